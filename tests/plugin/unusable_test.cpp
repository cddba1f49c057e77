// What is no plug-in is refused in one line that names the file, whatever it does when it is loaded.
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

namespace tribunal::plugin_tests {
namespace {

void expect_refused(const std::string& file, const std::string& says) {
  const cli::Ended ended = run_try({"--plugin", file, "--seconds", "5"});
  EXPECT_EQ(ended.status, 2) << file << ended.out;
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_NE(ended.err.find(file), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
}

TEST(UnusablePlugins, AreNamedWithTheReason) {
  const cli::Folder folder;
  expect_refused(folder / "missing.so", "cannot be loaded: cannot open shared object file");
  expect_refused(folder.write("text.so", "not a library\n"), "cannot be loaded");
  expect_refused(folder.write("empty.so", ""), "cannot be loaded");
  expect_refused("/tmp", "cannot be loaded");
  expect_refused(module_file("unresolved"), "a_function_that_nobody_defines");
  expect_refused(module_file("no_entry"), "defines none of");
  expect_refused(module_file("other_version"), "version 2 of the plug-in interface, not 1");
  expect_refused(module_file("offers_nothing"), "offers no predicate");
  expect_refused(module_file("dies_when_loaded"), "signal: Aborted");
}

TEST(UnusablePlugins, TheProgramItselfIsNone) {
  const cli::Ended ended = run_try({"--plugin", TRIBUNAL_PROGRAM});
  EXPECT_EQ(ended.status, 2) << ended.out;
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
}

}  // namespace
}  // namespace tribunal::plugin_tests
