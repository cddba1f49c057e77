// tribunal bench: what users type and what comes back.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tribunal::cli {
namespace {

std::vector<std::string> bench(std::vector<std::string> more) {
  std::vector<std::string> words{"bench",         "predicates", "--queries",  "300",
                                 "--repetitions", "2",          "--progress", "none"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Bench, TablesShowTimesRatesAndRatios) {
  const Ended ended = tribunal(bench({"--backend", "double", "--backend", "filtered", "--backend", "knuth",
                                      "--predicate", "incircle", "--family", "uni", "--family", "degF"}));
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(ended.err.empty()) << ended.err;
  EXPECT_EQ(ended.out.find("incircle, ns"), 0U) << ended.out;
  for (const char* text : {"uni", "degF", "refused", "!0.", "filtered / double, uni, incircle"})
    EXPECT_NE(ended.out.find(text), std::string::npos) << text << " is missing:\n" << ended.out;
  EXPECT_EQ(ended.out.find("orient2d"), std::string::npos) << ended.out;
}

TEST(Bench, DocumentHoldsWhatWasAsked) {
  auto words = bench({"--backend", "gmp", "--backend", "double", "--family", "degF", "--json"});
  const auto document = tribunal(words).json();
  EXPECT_EQ(document.at("queries"), 300);
  EXPECT_EQ(document.at("repetitions"), 2);
  EXPECT_FALSE(document.at("build").at("flags").get<std::string>().empty());
  ASSERT_EQ(document.at("cells").size(), 8U);
  for (const auto& cell : document.at("cells")) {
    EXPECT_EQ(cell.at("family"), "degF");
    if (cell.at("subject") == "gmp") {
      EXPECT_EQ(cell.at("outcome"), "timed");
      EXPECT_EQ(cell.at("wrong"), 0);
      EXPECT_EQ(cell.at("stages"), nlohmann::json({{"exact", 1.0}}));
      EXPECT_GT(cell.at("nanoseconds"), 0);
    } else {
      EXPECT_EQ(cell.at("outcome"), "wrong_signs");
      EXPECT_GT(cell.at("wrong_rate"), 0.1);
      EXPECT_FALSE(cell.contains("nanoseconds")) << "a wrong sign has no speed";
    }
  }
}

TEST(Bench, SameSeedSameSigns) {
  const auto rates = [](const char* seed) {
    std::vector<double> all;
    const auto document =
        tribunal(bench({"--backend", "double", "--family", "near", "--seed", seed, "--json"})).json();
    for (const auto& cell : document.at("cells")) all.push_back(cell.at("wrong_rate").get<double>());
    return all;
  };
  EXPECT_EQ(rates("7"), rates("7"));
  EXPECT_NE(rates("7"), rates("8"));
}

TEST(Bench, AlgorithmsRaceInAllTheVariantsNamed) {
  const Ended ended = tribunal({"bench", "algorithms", "-n", "200", "--repetitions", "2", "--algorithm",
                                "green-sibson", "--set", "location=walk", "--set", "location=history",
                                "--order", "brio", "--order", "x", "--json", "--progress", "none"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  std::set<std::string> names;
  const auto document = ended.json();
  for (const auto& time : document.at("times")) {
    names.insert(time.at("contestant").get<std::string>());
    EXPECT_EQ(time.at("outcome"), "ok");
    EXPECT_EQ(time.at("n"), 200);
    EXPECT_GT(time.at("seconds"), 0);
  }
  const std::set<std::string> expected{
      "green-sibson, filtered, brio order", "green-sibson, filtered, x order",
      "green-sibson location=walk, filtered, brio order", "green-sibson location=walk, filtered, x order"};
  EXPECT_EQ(names, expected);
  EXPECT_TRUE(document.at("ratios").empty()) << "there is no rival";
}

TEST(Bench, SegmentsAndDomainsAreRacedByWhatTakesThem) {
  const Ended ended =
      tribunal({"bench", "algorithms", "--dataset", "gulf", "--algorithm", "constrained", "--algorithm",
                "chew", "--algorithm", "bowyer", "--repetitions", "2", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto times = ended.json().at("times");
  ASSERT_EQ(times.size(), 3U);
  const std::vector<std::string> kinds{"graph", "refinement", "triangulation"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(times[i].at("kind"), kinds[i]);
    EXPECT_EQ(times[i].at("outcome"), "ok");
    EXPECT_EQ(times[i].at("n"), 820);
    EXPECT_GT(times[i].at("triangles"), 800);
  }
  EXPECT_GT(times[1].at("vertices"), 820);
  EXPECT_NEAR(times[1].at("angle").get<double>(), 30, 1e-9);
}

TEST(Bench, WhatDoesNotEndInTimeHasNoTime) {
  const Ended ended = tribunal({"bench", "algorithms", "--dataset", "slot", "--algorithm", "chew", "--set",
                                "vertices=400000000", "--repetitions", "1", "--seconds", "1", "--json"});
  EXPECT_EQ(ended.status, 1);
  const auto time = ended.json().at("times").at(0);
  EXPECT_EQ(time.at("outcome"), "timeout");
  EXPECT_FALSE(time.contains("seconds"));
}

TEST(Bench, AWrongMeshHasNoTimeAndFails) {
  const Ended ended = tribunal({"bench", "algorithms", "--dataset", "near-circle", "-n", "400", "--backend",
                                "float", "--repetitions", "1", "--json"});
  EXPECT_EQ(ended.status, 1);
  const auto time = ended.json().at("times").at(0);
  EXPECT_NE(time.at("outcome"), "ok");
  EXPECT_FALSE(time.contains("seconds"));
  EXPECT_FALSE(time.at("reason").get<std::string>().empty());
}

TEST(Bench, MistakesAreToldInOneLineWithStatusTwo) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"bench"},
                                             {"bench", "sorting"},
                                             {"bench", "predicates", "--backend", "abacus"},
                                             {"bench", "algorithms", "--algorithm", "magic"},
                                             {"bench", "algorithms", "--order", "chaos"},
                                             {"bench", "algorithms", "--dataset", "nowhere"},
                                             {"bench", "algorithms", "--set", "location"},
                                             {"bench", "algorithms", "--set", "location=taxi"},
                                             {"bench", "algorithms", "--backend", "abacus"},
                                             {"bench", "algorithms", "-n", "0"},
                                             {"bench", "algorithms", "--seconds", "0"},
                                             {"bench", "algorithms", "--algorithm", "chew"},
                                             {"bench", "algorithms", "--algorithm", "adaptive"},
                                             {"bench", "predicates", "--predicate", "handedness"},
                                             {"bench", "predicates", "--family", "addams"},
                                             {"bench", "predicates", "--queries", "0"},
                                             {"bench", "predicates", "--queries", "-1"},
                                             {"bench", "predicates", "--queries", "many"},
                                             {"bench", "predicates", "--repetitions", "0"}}) {
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2) << words.back();
    EXPECT_TRUE(ended.one_line_error()) << words.back() << ": " << ended.err;
    EXPECT_TRUE(ended.out.empty()) << words.back();
  }
}

}  // namespace
}  // namespace tribunal::cli
