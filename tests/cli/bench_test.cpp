// tribunal bench predicates: what users type and what comes back.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

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

TEST(Bench, MistakesAreToldInOneLineWithStatusTwo) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"bench"},
                                             {"bench", "sorting"},
                                             {"bench", "predicates", "--backend", "abacus"},
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
