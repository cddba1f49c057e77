// What users type and what comes back: list, points, sign, help.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tribunal::cli {
namespace {

TEST(Help, EveryVerbShowsAnExample) {
  for (const char* verb : {"list", "points", "sign", "triangulate", "verify", "optimize", "refine", "bench",
                           "fuzz", "run", "claims", "report", "cell"}) {
    const Ended help = tribunal({verb, "--help"});
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_NE(help.out.find("Example: tribunal " + std::string(verb)), std::string::npos) << verb;
    EXPECT_TRUE(help.err.empty()) << verb;
  }
}

TEST(Help, ProgramAndVersion) {
  EXPECT_EQ(tribunal({"--help"}).status, 0);
  EXPECT_EQ(tribunal({"--version"}).out, "tribunal 0.1.0\n");
}

TEST(Usage, MistakesAreToldInOneLineWithStatusTwo) {
  const std::vector<std::vector<std::string>> mistakes{
      {},
      {"dance"},
      {"list"},
      {"list", "cheeses"},
      {"list", "backends", "--frobnicate"},
      {"points", "nowhere"},
      {"points", "grid", "-n", "0"},
      {"points", "grid", "-n", "many"},
      {"points", "grid", "-n", "-5"},
      {"points", "grid", "--bits", "54"},
      {"points", "grid", "-o", "/nonexistent/folder/points.xy"},
      {"points", "grid", "-o", "points.docx"},
      {"sign", "handedness", "1", "2"},
      {"sign", "orient2d", "1", "2", "3"},
      {"sign", "orient2d", "0", "0", "1", "1", "2", "nan"},
      {"sign", "orient2d", "0", "0", "1", "1", "2", "-inf"},
      {"sign", "orient2d", "0", "0", "1", "1", "2", "1e999"},
      {"sign", "orient2d", "0", "0", "1", "1", "2", "3x"},
      {"sign", "orient2d", "0", "0", "1", "1", "2", "3", "--backend", "oracle"},
      {"triangulate", "grid", "--algorithm", "magic"},
      {"triangulate", "grid", "--order", "chaos"},
      {"triangulate", "grid", "--progress", "loud"},
      {"claims", "no-such-claim"},
      {"claims", "--tier", "heroic"},
      {"run", "plan.toml"},
      {"report", "/nonexistent"},
      {"cell", "{"},
      {"bench", "predicates", "--dataset", "uniform"},
      {"bench", "predicates", "-n", "7"},
      {"bench", "algorithms", "--family", "uni"},
      {"triangulate", "unifrom", "-n", "10"},
      {},
      {"cell", "{\"task\":\"magic\"}"},
  };
  for (const auto& words : mistakes) {
    const Ended ended = tribunal(words);
    std::string line;
    for (const auto& word : words) line += word + " ";
    EXPECT_EQ(ended.status, 2) << line << ended.err;
    EXPECT_TRUE(ended.one_line_error()) << line << "\n" << ended.err;
    EXPECT_TRUE(ended.out.empty()) << line;
  }
}

TEST(List, AlgorithmsNameTheirVerb) {
  std::map<std::string, std::string> verbs;
  for (const nlohmann::json document = tribunal({"list", "algorithms", "--json"}).json();
       const auto& algorithm : document.at("algorithms"))
    verbs[algorithm.at("name")] = algorithm.at("verb");
  EXPECT_EQ(verbs.at("bowyer"), "triangulate");
  for (const char* refiner : {"chew", "stretched", "adaptive"}) EXPECT_EQ(verbs.at(refiner), "refine");
}

TEST(List, EverythingHasANameAndASummary) {
  for (const char* what : {"algorithms", "backends", "datasets", "formats"}) {
    const Ended ended = tribunal({"list", what, "--json"});
    ASSERT_EQ(ended.status, 0) << what;
    const auto entries = ended.json().at(what);
    EXPECT_GE(entries.size(), 3U) << what;
    for (const auto& entry : entries) {
      EXPECT_FALSE(entry.at("name").get<std::string>().empty());
      EXPECT_FALSE(entry.at("summary").get<std::string>().empty()) << entry;
    }
  }
}

TEST(List, PromisedNamesAreThere) {
  const auto names = [](const char* what) {
    std::set<std::string> all;
    const auto listed = tribunal({"list", what, "--json"}).json();
    for (const auto& entry : listed.at(what)) all.insert(entry.at("name").get<std::string>());
    return all;
  };
  const auto backends = names("backends"), algorithms = names("algorithms"), datasets = names("datasets");
  for (const char* name :
       {"double", "double-fma", "float", "long-double", "knuth", "knuth64", "redundant", "knuth-as-printed",
        "fortune-van-wyk", "interval", "adaptive", "filtered", "fixed", "gmp"})
    EXPECT_TRUE(backends.count(name)) << name;
  for (const char* name : {"bowyer", "watson", "green-sibson"}) EXPECT_TRUE(algorithms.count(name)) << name;
  for (const char* name : {"uniform", "normal", "clusters", "grid", "tilted-grid", "rotated-grid", "circle",
                           "near-circle", "collinear", "near-collinear", "duplicates", "spiral", "kettner",
                           "mixed-exponents", "lawson-worst-case", "counties", "coast"})
    EXPECT_TRUE(datasets.count(name)) << name;
}

TEST(List, ClaimsCarrySourceAndExpectation) {
  const auto document = tribunal({"list", "claims", "--json"}).json();
  for (const auto& claim : document.at("claims")) {
    EXPECT_FALSE(claim.at("source").get<std::string>().empty());
    EXPECT_TRUE(claim.at("expected") == "reproduced" || claim.at("expected") == "refuted");
  }
}

TEST(Points, SameSeedSameBytesAndAnotherSeedOthers) {
  const std::string one = tribunal({"points", "uniform", "-n", "100", "--seed", "3"}).out;
  EXPECT_EQ(one, tribunal({"points", "uniform", "-n", "100", "--seed", "3"}).out);
  EXPECT_NE(one, tribunal({"points", "uniform", "-n", "100", "--seed", "4"}).out);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 100);
}

TEST(Points, BitsQuantiseToALattice) {
  const nlohmann::json points =
      tribunal({"points", "normal", "-n", "200", "--bits", "10", "--json"}).json().at("points");
  ASSERT_EQ(points.size(), 200U);
  for (const auto& p : points)
    for (const double c : p) {
      EXPECT_EQ(c, std::floor(c));
      EXPECT_TRUE(0 <= c && c < 1024) << c;
    }
}

TEST(Sign, NegativeNumbersNeedNoEscaping) {
  const nlohmann::json signs =
      tribunal({"sign", "orient2d", "-1", "-1", "-.5", "-0x1p-1", "-1e0", "+3", "--json"}).json().at("signs");
  EXPECT_GE(signs.size(), 7U);
  for (const auto& s : signs) EXPECT_TRUE(s.at("sign") == "+" || s.at("sign") == "out_of_domain") << s;
}

TEST(Sign, BackendsDifferWhereDoublesRound) {
  const std::vector<std::string> query{"sign", "orient2d",           "0.5",   "0.5", "12", "12",
                                       "24",   "24.000000000000004", "--json"};
  const auto document = tribunal(query).json();
  for (const auto& s : document.at("signs"))
    EXPECT_TRUE(s.at("sign") == "+" || s.at("stage") == "rounded" || s.at("sign") == "out_of_domain") << s;
}

TEST(Sign, ThePrintedProgramIsWrongOnACircle) {
  // Four points of the circle of radius 5 around the origin: exactly zero.
  const std::vector<std::string> query{"sign", "incircle", "5", "0",  "0",     "5",
                                       "-5",   "0",        "3", "-4", "--json"};
  const auto document = tribunal(query).json();
  for (const auto& s : document.at("signs"))
    EXPECT_EQ(s.at("sign") == "0", s.at("backend") != "knuth-as-printed") << s;
}

TEST(Sign, RefusalsSayWhy) {
  const auto answer =
      tribunal({"sign", "orient2d", "0", "0", "0.5", "1", "1", "1", "--backend", "knuth", "--json"}).json();
  EXPECT_EQ(answer.at("signs")[0].at("sign"), "out_of_domain");
  EXPECT_FALSE(answer.at("signs")[0].at("reason").get<std::string>().empty());
}

TEST(Sign, InSpace) {
  const Ended ended = tribunal({"sign", "insphere", "0", "0", "0", "1", "0", "0", "0", "1", "0", "0", "0",
                                "1", "0.25", "0.25", "0.25", "--backend", "gmp"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out, "gmp  +  exact\n");
}

}  // namespace
}  // namespace tribunal::cli
