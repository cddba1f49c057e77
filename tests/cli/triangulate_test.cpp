// triangulate and verify, from file to file.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tribunal::cli {
namespace {

const std::vector<std::string> insertions{"bowyer", "watson", "green-sibson"};

TEST(Triangulate, StatsHoldWhatIsPromised) {
  const Folder folder;
  const std::string points = folder / "p.xy", stats = folder / "s.json";
  ASSERT_EQ(tribunal({"points", "uniform", "-n", "500", "-o", points}).status, 0);
  for (const std::string& algorithm : insertions) {
    ASSERT_EQ(tribunal({"triangulate", points, "--algorithm", algorithm, "--stats", stats}).status, 0);
    const auto s = nlohmann::json::parse(read(stats));
    for (const char* key :
         {"algorithm", "backend", "n", "duplicates", "outcome", "triangles", "hull", "tau", "tau_with_ghosts",
          "created", "flips", "history", "predicates", "seconds", "peak_bytes", "dimension"})
      EXPECT_TRUE(s.contains(key)) << key;
    EXPECT_EQ(s["triangles"], 2 * 500 - 2 - s["hull"].get<int>());
    EXPECT_EQ(s["history"].is_null(), algorithm != "green-sibson");
    EXPECT_GT(s["predicates"]["incircle"]["stages"]["filter"], 1000);
    if (algorithm != "green-sibson") continue;
    for (const char* key : {"nodes", "depth_mean", "depth_max"}) EXPECT_TRUE(s["history"].contains(key));
  }
}

TEST(Triangulate, RealSitesByEveryAlgorithmAndBackend) {
  const Folder folder;
  const std::string points = folder / "coast.xy", mesh = folder / "coast.off";
  ASSERT_EQ(tribunal({"points", "coast", "-o", points}).status, 0);
  std::set<std::string> digests;
  std::set<int> taus;
  for (const std::string& algorithm : insertions)
    for (const char* backend : {"filtered", "fortune-van-wyk", "gmp"}) {
      const Ended ended = tribunal(
          {"triangulate", points, "--algorithm", algorithm, "--backend", backend, "-o", mesh, "--json"});
      ASSERT_EQ(ended.status, 0) << ended.err;
      digests.insert(ended.json()["digest"].get<std::string>());
      taus.insert(ended.json()["tau"].get<int>());
      const Ended verdict = tribunal({"verify", points, mesh, "--json"});
      EXPECT_EQ(verdict.status, 0) << verdict.out;
      EXPECT_EQ(verdict.json()["valid"], true);
    }
  EXPECT_EQ(digests.size(), 1U);
  EXPECT_EQ(taus.size(), 1U);
}

TEST(Triangulate, ParametersAreSetByName) {
  const auto plain = tribunal({"triangulate", "uniform", "-n", "300", "--json"}).json();
  EXPECT_EQ(plain["parameters"], nlohmann::json::object());
  const auto walk =
      tribunal({"triangulate", "uniform", "-n", "300", "--set", "location=walk", "--json"}).json();
  EXPECT_EQ(walk["parameters"]["location"], "walk");
  EXPECT_EQ(walk["digest"], plain["digest"]);
  EXPECT_TRUE(walk["history"].is_null());
  EXPECT_FALSE(plain["history"].is_null());
}

TEST(Triangulate, ParametersThatThereAreNotAreRefusedInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
      {{"--set", "location=taxi"}, "location is one of history, walk, jump-and-walk, not \"taxi\""},
      {{"--set", "place=walk"}, "green-sibson has no parameter \"place\" (there is location)"},
      {{"--set", "location"}, "--set wants NAME=VALUE, not 'location'"},
      {{"--set", "location=walk", "--set", "location=walk"}, "--set gives location twice"},
      {{"--set", "location=walk", "--algorithm", "bowyer"}, "bowyer takes no parameters"},
  };
  for (const auto& [options, reason] : mistakes) {
    std::vector<std::string> words{"triangulate", "uniform"};
    words.insert(words.end(), options.begin(), options.end());
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2) << reason;
    EXPECT_EQ(ended.err, "tribunal: " + reason + "\n");
  }
}

TEST(Triangulate, EveryMeshFormatVerifies) {
  const Folder folder;
  const std::string points = folder / "p.node";
  ASSERT_EQ(tribunal({"points", "tilted-grid", "-n", "400", "-o", points}).status, 0);
  for (const char* name : {"mesh.off", "mesh.ele"}) {
    const std::string mesh = folder / name;
    ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
    EXPECT_EQ(tribunal({"verify", points, mesh}).status, 0) << name;
  }
  EXPECT_FALSE(read(folder / "mesh.node").empty());
}

TEST(Triangulate, StandardInput) {
  const Ended ended = tribunal({"triangulate", "-", "--json"}, "0 0\n1 0\n0 1\n");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.json()["triangles"], 1);
}

TEST(Triangulate, LowDimensionIsFine) {
  const auto one = tribunal({"triangulate", "-", "--json"}, "7 8\n").json();
  EXPECT_EQ(one["dimension"], 0);
  const auto line = tribunal({"triangulate", "-", "--json"}, "2 2\n0 0\n1 1\n").json();
  EXPECT_EQ(line["dimension"], 1);
  EXPECT_EQ(line["outcome"], "ok");
  EXPECT_EQ(line["edges"], nlohmann::json::parse("[[1,2],[2,0]]"));
}

TEST(Triangulate, DuplicatesAreReportedWithTheirLines) {
  const Ended ended = tribunal({"triangulate", "-", "--json"}, "0 0\n1 0\n0 1\n# a comment\n1 0\n");
  EXPECT_EQ(ended.json()["duplicates"], 1);
  EXPECT_NE(ended.err.find(":5: the same point as line 2"), std::string::npos) << ended.err;
}

TEST(Triangulate, ARefusalNamesFileLineAndReason) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n1 0\n0.5 1\n");
  const Ended ended = tribunal({"triangulate", points, "--backend", "knuth"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err.rfind("tribunal: " + points + ":3: knuth: ", 0), 0U) << ended.err;
}

TEST(Triangulate, KnuthRefusesTheCounties) {
  const Ended ended = tribunal({"triangulate", "counties", "--backend", "knuth"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error());
}

TEST(Triangulate, PictureIsDrawn) {
  const Folder folder;
  const std::string picture = folder / "p.svg";
  ASSERT_EQ(tribunal({"triangulate", "uniform", "-n", "50", "--picture", picture}).status, 0);
  const std::string svg = read(picture);
  EXPECT_EQ(svg.rfind("<svg", 0), 0U);
  EXPECT_GT(std::count(svg.begin(), svg.end(), 'Z'), 80);
  EXPECT_EQ(tribunal({"triangulate", "uniform", "--picture", folder / "p.gif"}).status, 2);
}

TEST(Verify, NamesTheFault) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n4 0\n4 3\n0 3\n1 1\n");
  const std::string bad =
      folder.write("bad.off", "OFF\n5 2 0\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n1 1 0\n3 0 1 2\n3 0 2 3\n");
  const Ended ended = tribunal({"verify", points, bad, "--json"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.json()["valid"], false);
  std::set<std::string> kinds;
  const auto document = ended.json();
  for (const auto& fault : document["faults"]) kinds.insert(fault["kind"].get<std::string>());
  EXPECT_TRUE(kinds.count("missing_site")) << ended.out;
}

TEST(Verify, ATriangulationNeedNotBeDelaunay) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n4 -1\n8 0\n4 1\n");
  const std::string long_diagonal = folder.write("m.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  EXPECT_EQ(tribunal({"verify", points, long_diagonal}).status, 1);
  EXPECT_EQ(tribunal({"verify", points, long_diagonal, "--kind", "triangulation"}).status, 0);
}

}  // namespace
}  // namespace tribunal::cli
