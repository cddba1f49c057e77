// What `tribunal try --json` prints obeys its schema, whatever came of the trial.
#include "tests/cli/schema.hpp"

#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

namespace tribunal::plugin_tests {
namespace {

TEST(TrySchema, DocumentsObeyIt) {
  const auto schema = nlohmann::json::parse(cli::read(TRIBUNAL_SOURCE_DIR "/cli/schemas/try.schema.json"));
  for (const char* name : {"naive", "integers", "lawson", "fan", "crashes", "wild_corners", "hangs"}) {
    const cli::Ended ended = try_module(name, {"--seconds", "0.5"});
    ASSERT_LE(ended.status, 1) << name << ended.err;
    EXPECT_EQ(cli::schema_fault(schema, ended.json()), "") << name;
  }
  const cli::Ended ended = run_try({"--command", ": {points} {mesh}", "-n", "4"});
  EXPECT_EQ(cli::schema_fault(schema, ended.json()), "");
}

}  // namespace
}  // namespace tribunal::plugin_tests
