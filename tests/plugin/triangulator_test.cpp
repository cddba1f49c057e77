// Triangulators of outsiders: each mesh is checked exactly, each failure cut down to few points.
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tribunal::plugin_tests {
namespace {

TEST(Triangulators, TheExampleIsRightInItsDomain) {
  const cli::Ended ended = try_module("lawson");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto document = ended.json();
  std::set<std::string> right;
  for (const auto& exercise : document["exercises"])
    if (exercise["outcome"] == "right") right.insert(exercise["input"]);
  EXPECT_TRUE(right.count("grid")) << ended.out;
  EXPECT_TRUE(right.count("collinear")) << ended.out;
  EXPECT_GT(count(document, "refused"), 0);
}

TEST(Triangulators, AFanIsCaughtInAtMostFivePoints) {
  const cli::Ended ended = try_module("fan");
  ASSERT_EQ(ended.status, 1) << ended.err;
  const auto document = ended.json();
  ASSERT_FALSE(document["counterexamples"].empty());
  for (const auto& example : document["counterexamples"]) {
    EXPECT_LE(example["points"].size(), 2 * 5U) << example;
    EXPECT_NE(example["got"], "");
  }
  EXPECT_EQ(replay_status(document["counterexamples"][0]["replay"]), 1);
}

TEST(Triangulators, WildCornersAndFloodsOfTrianglesAreWrongAndNoMore) {
  const cli::Ended small = run_try({"--plugin", module_file("wild_corners"), "--dataset", "grid", "-n", "4"});
  EXPECT_EQ(small.status, 1) << small.err;
  EXPECT_NE(small.out.find("index_out_of_range"), std::string::npos) << small.out;
  const cli::Folder folder;
  std::string points;
  for (int i = 0; i < 12; ++i) points += std::to_string(i) + " " + std::to_string(i * i) + "\n";
  const cli::Ended many = try_module("wild_corners", {"--points", folder.write("p.xy", points)});
  EXPECT_EQ(many.status, 1) << many.err;
  EXPECT_NE(many.out.find("more than 2n"), std::string::npos) << many.out;
}

TEST(Triangulators, ThreeHangsAreEnough) {
  const auto document = try_module("hangs", {"--seconds", "0.3"}).json();
  long hung = 0, untried = 0;
  for (const auto& exercise : document["exercises"]) {
    if (exercise["task"] != "delaunay") continue;
    hung += exercise["outcome"] == "hang";
    untried += exercise["outcome"] == "untried";
  }
  EXPECT_EQ(hung, 3);
  EXPECT_GT(untried, 5);
}

}  // namespace
}  // namespace tribunal::plugin_tests
