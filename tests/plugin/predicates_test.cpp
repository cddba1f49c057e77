// Predicates of outsiders: right ones are clean, broken ones are caught with a counterexample that holds.
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tribunal::plugin_tests {
namespace {

/// Caught: exit status 1, a counterexample whose sign is not the true one, and a replay that fails again.
void expect_caught(const std::string& name, const std::string& predicate) {
  const cli::Ended ended = try_module(name);
  ASSERT_EQ(ended.status, 1) << name << ": " << ended.err;
  const auto document = ended.json();
  EXPECT_FALSE(document["clean"]);
  ASSERT_FALSE(document["counterexamples"].empty()) << name;
  std::set<std::string> tasks;
  for (const auto& example : document["counterexamples"]) {
    tasks.insert(example["task"]);
    EXPECT_NE(example["exact"], example["got"]) << example;
  }
  EXPECT_TRUE(tasks.count(predicate));
  const std::string replay = document["counterexamples"][0]["replay"];
  EXPECT_EQ(replay_status(replay), 1) << replay;
}

TEST(BrokenPredicates, NaiveDoublesAreCaught) {
  expect_caught("naive", "orient2d");
  expect_caught("naive", "incircle");
}
TEST(BrokenPredicates, AnEpsilonIsCaught) { expect_caught("epsilon", "orient2d"); }
TEST(BrokenPredicates, ContractionIsCaught) { expect_caught("contracted", "orient2d"); }
TEST(BrokenPredicates, AWrongSplitterIsCaught) { expect_caught("wrong_splitter", "orient2d"); }

TEST(BrokenPredicates, TheRightSplitterIsNot) {
  const cli::Ended ended = try_module("right_splitter");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_GT(count(ended.json(), "right"), 5);
  EXPECT_GT(count(ended.json(), "refused"), 0) << "it refuses extreme exponents";
}

TEST(BrokenPredicates, CounterexamplesAreShort) {
  const auto document = try_module("epsilon").json();
  std::size_t shortest = 1000;
  for (const auto& example : document["counterexamples"]) {
    std::size_t digits = 0;
    for (const std::string number : example["points"]) digits += number.size();
    shortest = std::min(shortest, digits);
  }
  EXPECT_LE(shortest, 6 * 8U) << "an epsilon needs no long mantissas";
}

TEST(BrokenPredicates, ACrashIsAnOutcomeAndNamesItsQuery) {
  const cli::Ended ended = try_module("crashes");
  ASSERT_EQ(ended.status, 1) << ended.err;
  const auto document = ended.json();
  EXPECT_GT(count(document, "crash"), 0);
  bool replayed = false;
  for (const auto& example : document["counterexamples"]) {
    if (example["outcome"] != "crash" || replayed) continue;
    EXPECT_EQ(replay_status(example["replay"]), 1);
    replayed = true;
  }
  EXPECT_TRUE(replayed);
}

TEST(BrokenPredicates, ACrashInBindIsAnOutcome) {
  const cli::Ended ended = try_module("crashes_in_bind");
  ASSERT_EQ(ended.status, 1) << ended.err;
  const auto document = ended.json();
  for (const auto& exercise : document["exercises"]) {
    EXPECT_EQ(exercise["outcome"], "crash");
    EXPECT_NE(exercise["reason"].get<std::string>().find("in bind"), std::string::npos) << exercise;
  }
}

TEST(BrokenPredicates, WhatHangsIsStoppedOnceAndNotAskedAgain) {
  const cli::Ended ended = try_module("hangs", {"--seconds", "0.3"});
  ASSERT_EQ(ended.status, 1) << ended.err;
  const auto document = ended.json();
  long hung = 0, untried = 0;
  for (const auto& exercise : document["exercises"]) {
    if (exercise["task"] != "orient2d") continue;
    hung += exercise["outcome"] == "hang";
    untried += exercise["outcome"] == "untried";
  }
  EXPECT_EQ(hung, 1);
  EXPECT_GT(untried, 5);
}

TEST(BrokenPredicates, ABatchMustAgreeWithSingleAnswers) {
  const cli::Ended ended = try_module("batch_differs");
  EXPECT_EQ(ended.status, 1) << ended.out;
  EXPECT_NE(ended.out.find("its batch gives"), std::string::npos) << ended.out;
}

TEST(BrokenPredicates, TheFloatingPointEnvironmentMustBeLeftAlone) {
  const cli::Ended ended = try_module("changes_rounding");
  EXPECT_EQ(ended.status, 1) << ended.out;
  EXPECT_NE(ended.out.find("changes the floating-point environment"), std::string::npos) << ended.out;
}

TEST(GoodPredicates, ADomainIsNoFailure) {
  const cli::Ended ended = try_module("integers");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto document = ended.json();
  EXPECT_TRUE(document["clean"]);
  EXPECT_GE(count(document, "right"), 9) << "three predicates on 14, 24 and 28 bits";
  EXPECT_GT(count(document, "refused"), 0);
  EXPECT_TRUE(document["counterexamples"].empty());
}

TEST(GoodPredicates, OnlyWhatIsRightHasATime) {
  for (const char* name : {"naive", "integers"}) {
    const auto document = try_module(name).json();
    for (const auto& exercise : document["exercises"]) {
      const bool timed = exercise["outcome"] == "right" && exercise["input"] != "fuzz";
      EXPECT_EQ(exercise["seconds"].is_number(), timed) << exercise;
    }
  }
}

TEST(GoodPredicates, OneQueryAlone) {
  EXPECT_EQ(try_module("naive", {"--query", "orient2d 0 0 1 0 0 1"}).status, 0);
  EXPECT_EQ(try_module("naive", {"--query", "orient2d 0x1p+0 1 0 0x1p-54 0 0"}).status, 1);
  EXPECT_EQ(try_module("naive", {"--query", "orient3d 0 0 0 1 0 0 0 1 0 0 0 1"}).status, 2);
  EXPECT_EQ(try_module("naive", {"--query", "orient2d 0 0 1 0 0"}).status, 2);
  EXPECT_EQ(try_module("naive", {"--query", "orient2d 0 0 1 0 0 x"}).status, 2);
}

TEST(GoodPredicates, SameSeedSameFindings) {
  const auto findings = [](const std::string& seed) {
    auto document = try_module("naive", {"--seed", seed}).json();
    for (auto& exercise : document["exercises"]) exercise.erase("seconds");
    return document.dump();
  };
  EXPECT_EQ(findings("7"), findings("7"));
  EXPECT_NE(findings("7"), findings("8"));
}

TEST(GoodPredicates, PicturesAreDrawnOnRequest) {
  const cli::Folder folder;
  ASSERT_EQ(try_module("epsilon", {"--picture", folder / "pictures"}).status, 1);
  std::size_t drawn = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pictures")) {
    EXPECT_EQ(cli::read(entry.path().string()).rfind("<svg", 0), 0U) << entry.path();
    ++drawn;
  }
  EXPECT_GT(drawn, 0U);
}

}  // namespace
}  // namespace tribunal::plugin_tests
