// tribunal fuzz --plugin: an outsider's misbehaviour is an outcome of the outsider, and nothing is lost by
// it.
#include "tests/cli/schema.hpp"
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

namespace tribunal::plugin_tests {
namespace {

/// An environment variable for the length of a test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { unsetenv(name_); }

 private:
  const char* name_;
};

cli::Ended hunt(std::vector<std::string> more = {}) {
  std::vector<std::string> words{"fuzz",   "--plugin",   module_file("misbehaves"),
                                 "--json", "--progress", "none"};
  if (std::ranges::find(more, "--seconds") == more.end())
    words.insert(words.end(), {"--queries", "20000", "--predicate", "orient2d"});
  words.insert(words.end(), more.begin(), more.end());
  return cli::tribunal(words);
}

void expect_document(const cli::Ended& ended, const char* what) {
  const auto schema =
      nlohmann::json::parse(cli::read(std::string(TRIBUNAL_SOURCE_DIR) + "/cli/schemas/fuzz.schema.json"));
  ASSERT_TRUE(nlohmann::json::accept(ended.out)) << what << ": " << ended.out << ended.err;
  EXPECT_EQ(cli::schema_fault(schema, ended.json()), "") << what;
}

TEST(Hunts, AWellBehavedPluginIsClean) {
  const cli::Ended ended = hunt();
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  expect_document(ended, "good");
  EXPECT_GT(ended.json()["checked"], 0);
}

TEST(Hunts, DeathIsAnOutcomeOfThePlugin) {
  const std::pair<const char*, const char*> all[] = {
      {"exits", "misbehaves: exit status 0 without a result"},
      {"crashes", "misbehaves: signal: Segmentation fault"},
  };
  for (const auto& [misbehaviour, says] : all) {
    const Variable mode("MISBEHAVIOUR", misbehaviour);
    const cli::Ended ended = hunt({"--backend", "gmp"});
    EXPECT_EQ(ended.status, 1) << misbehaviour << ended.err;
    expect_document(ended, misbehaviour);
    ASSERT_EQ(ended.json()["breaches"].size(), 1U) << misbehaviour;
    EXPECT_EQ(ended.json()["breaches"][0].get<std::string>().rfind(says, 0), 0U) << ended.out;
  }
}

TEST(Hunts, WhatHangsIsStopped) {
  const Variable mode("MISBEHAVIOUR", "hangs");
  const auto start = std::chrono::steady_clock::now();
  const cli::Ended ended = hunt({"--seconds", "0.5"});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_EQ(ended.status, 1) << ended.err;
  expect_document(ended, "hangs");
  EXPECT_NE(ended.out.find("misbehaves: no answer for"), std::string::npos) << ended.out;
}

TEST(Hunts, WhatAPluginPrintsIsNoPartOfTheDocument) {
  for (const char* misbehaviour :
       {"prints", "prints unflushed", "prints when loaded", "prints at the end", "crashes at the end"}) {
    const Variable mode("MISBEHAVIOUR", misbehaviour);
    const cli::Ended ended = hunt();
    EXPECT_EQ(ended.status, 0) << misbehaviour << ended.out << ended.err;
    expect_document(ended, misbehaviour);
  }
}

TEST(Hunts, AChangedEnvironmentIsBlamedOnThePlugin) {
  const Variable mode("MISBEHAVIOUR", "rounds when loaded");
  const cli::Ended ended = hunt({"--backend", "filtered"});
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  ASSERT_EQ(ended.json()["breaches"].size(), 1U);
  EXPECT_EQ(ended.json()["breaches"][0],
            "misbehaves: the rounding mode is not to nearest after it was loaded");
  EXPECT_TRUE(ended.json()["oracle"]["faults"].empty());
  EXPECT_TRUE(ended.json()["counterexamples"].empty()) << ended.out;
}

TEST(Hunts, APluginThatCannotBeLoadedIsBadInput) {
  const Variable mode("MISBEHAVIOUR", "exits when loaded");
  const cli::Ended ended = hunt();
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_NE(ended.err.find("misbehaves.so: fails when it is loaded"), std::string::npos) << ended.err;
}

TEST(Hunts, NothingJudgedIsNoSuccess) {
  const Variable mode("MISBEHAVIOUR", "refuses all");
  const cli::Ended ended = hunt();
  EXPECT_EQ(ended.status, 2) << ended.out;
  expect_document(ended, "refuses all");
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_NE(ended.err.find("misbehaves: nothing was judged, for it refused"), std::string::npos) << ended.err;
}

TEST(Hunts, ANameLeadsOutOfNoFolderAndPrintsHarmlessly) {
  const Variable mode("MISBEHAVIOUR", "is wrong"), name("NAME", "../../\033[31mescaped");
  const cli::Folder folder;
  const std::string pictures = folder / "a/b/pictures";
  const cli::Ended ended = hunt({"--picture", pictures, "--corpus", folder / "corpus"});
  ASSERT_EQ(ended.status, 1) << ended.err;
  ASSERT_EQ(ended.json()["counterexamples"].size(), 1U) << ended.out;
  const auto shown = ended.json()["counterexamples"][0];
  EXPECT_EQ(shown["backend"], "../../?[31mescaped");
  const std::filesystem::path picture = shown["picture"].get<std::string>();
  EXPECT_EQ(picture.parent_path(), pictures);
  EXPECT_TRUE(std::filesystem::exists(picture));
  EXPECT_TRUE(std::filesystem::exists(shown["file"].get<std::string>()));
  EXPECT_EQ(replay_status(shown["replay"]), 1) << shown["replay"];
}

TEST(Hunts, ReplaysAreReadyForAShell) {
  const Variable mode("MISBEHAVIOUR", "is wrong");
  const cli::Folder folder;
  const std::string copy = folder / "it's mine; $(exit 7).so";
  std::filesystem::copy_file(module_file("misbehaves"), copy);
  const cli::Ended ended =
      cli::tribunal({"fuzz", "--plugin", copy, "--queries", "20000", "--predicate", "orient2d", "--json"});
  ASSERT_EQ(ended.status, 1) << ended.err;
  EXPECT_EQ(replay_status(ended.json()["counterexamples"][0]["replay"]), 1) << ended.out;
}

TEST(Hunts, TwoOfOneNameAreToldApart) {
  const cli::Folder folder;
  const std::string copy = folder / "copy.so";
  std::filesystem::copy_file(module_file("misbehaves"), copy);
  const Variable name("NAME", "filtered");
  const cli::Ended ended = hunt({"--plugin", copy, "--plugin", copy, "--backend", "filtered"});
  std::vector<std::string> names;
  const nlohmann::json document = ended.json();
  for (const auto& tally : document["backends"])
    if (tally["predicate"] == "orient2d") names.push_back(tally["backend"]);
  EXPECT_EQ(names, (std::vector<std::string>{"filtered", "filtered (" + module_file("misbehaves") + ")",
                                             "filtered (" + copy + ")"}));
}

TEST(Trials, ABatchWritesSignsAndNothingElse) {
  const Variable mode("MISBEHAVIOUR", "sevens");
  const cli::Ended ended = try_module("misbehaves");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.out.find("its batch gives"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace tribunal::plugin_tests
