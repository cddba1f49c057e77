// optimize, from mesh to better mesh.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

namespace tribunal::cli {
namespace {

/// 200 uniform points, and a triangulation of them that is not Delaunay.
struct Sample {
  Folder folder;
  std::string points = folder / "p.xy", mesh = folder / "m.off";
  Sample() {
    EXPECT_EQ(tribunal({"points", "uniform", "-n", "200", "-o", points}).status, 0);
    EXPECT_EQ(tribunal({"triangulate", points, "--algorithm", "minmax-local", "-o", mesh}).status, 0);
  }
};

TEST(Optimize, ByCirclesGivesADelaunayMesh) {
  const Sample sample;
  const std::string better = sample.folder / "better.ele";
  ASSERT_EQ(tribunal({"verify", sample.points, sample.mesh}).status, 1) << "not Delaunay before";
  const Ended ended = tribunal({"optimize", sample.points, sample.mesh, "-o", better, "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(tribunal({"verify", sample.points, better}).status, 0);
  EXPECT_GT(ended.json()["counts"]["flips"], 0);
  EXPECT_GE(ended.json()["angles_after"]["smallest"], ended.json()["angles_before"]["smallest"]);
  const Ended fresh = tribunal({"triangulate", sample.points, "--json"});
  EXPECT_EQ(ended.json()["digest"], fresh.json()["digest"]) << "the one Delaunay triangulation";
}

TEST(Optimize, ByAnglesLowersTheLargest) {
  const Sample sample;
  const std::string delaunay = sample.folder / "d.off", local = sample.folder / "l.off";
  ASSERT_EQ(tribunal({"triangulate", sample.points, "-o", delaunay}).status, 0);
  const Ended flipped =
      tribunal({"optimize", sample.points, delaunay, "--criterion", "minmax", "-o", local, "--json"});
  ASSERT_EQ(flipped.status, 0) << flipped.err;
  const Ended inserted =
      tribunal({"optimize", sample.points, local, "--criterion", "minmax-global", "--json"});
  ASSERT_EQ(inserted.status, 0) << inserted.err;
  const auto flips = flipped.json(), insertions = inserted.json();
  EXPECT_LE(flips["angles_after"]["largest"], flips["angles_before"]["largest"]);
  EXPECT_EQ(insertions["angles_before"]["largest"], flips["angles_after"]["largest"]);
  EXPECT_LE(insertions["angles_after"]["largest"], insertions["angles_before"]["largest"]);
  EXPECT_EQ(tribunal({"verify", sample.points, local, "--kind", "triangulation"}).status, 0);
}

TEST(Optimize, SweepsAndTheStackAgree) {
  const Sample sample;
  std::vector<std::string> digests;
  for (const char* method : {"method=stack", "method=sweeps"}) {
    const Ended ended = tribunal({"optimize", sample.points, sample.mesh, "--set", method, "--json"});
    digests.push_back(ended.json()["digest"].get<std::string>());
  }
  EXPECT_EQ(digests[0], digests[1]);
}

TEST(Optimize, WritesStatsAndPicture) {
  const Sample sample;
  const std::string stats = sample.folder / "s.json", picture = sample.folder / "p.svg";
  const Ended ended =
      tribunal({"optimize", sample.points, sample.mesh, "--stats", stats, "--picture", picture});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("largest angle"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(read(stats))["outcome"], "ok");
  EXPECT_EQ(read(picture).rfind("<svg", 0), 0U);
}

TEST(Optimize, RefusesWhatItCannotUse) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n4 0\n4 3\n0 3\n1 1\n");
  const std::string holey =
      folder.write("m.off", "OFF\n5 2 0\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n1 1 0\n3 0 1 2\n3 0 2 3\n");
  const std::string better = folder / "better.off";
  const Ended refused = tribunal({"optimize", points, holey, "-o", better});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.one_line_error()) << refused.err;
  EXPECT_NE(refused.err.find("m.off: is no triangulation of"), std::string::npos) << refused.err;
  EXPECT_EQ(tribunal({"verify", points, better}).status, 2) << "nothing was written";
  EXPECT_EQ(tribunal({"optimize", points, holey, "--criterion", "minmx"}).status, 2);
  EXPECT_EQ(tribunal({"optimize", points, holey, "--set", "method=fast"}).status, 2);
  EXPECT_EQ(tribunal({"optimize", points, holey, "-o", holey}).status, 2) << "would overwrite its input";
}

/// The two widest points are farther apart than any double: 1.7 to either side of a height of 1.
TEST(Optimize, PointsAndMeshCannotBothBeStandardInput) {
  const Ended ended = tribunal({"optimize", "-", "-"}, "0 0\n1 0\n0 1\n");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("both want standard input"), std::string::npos) << ended.err;
}

TEST(Optimize, AnglesAreRightWhereDifferencesOverflow) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "-1.7e308 0\n1.7e308 0\n0 1e308\n"),
                    mesh = folder / "m.off";
  ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
  const auto angles = tribunal({"optimize", points, mesh, "--json"}).json().at("angles_after");
  EXPECT_NEAR(angles.at("smallest").get<double>(), 30.465544919, 1e-8);
  EXPECT_NEAR(angles.at("largest").get<double>(), 119.068910161, 1e-8);
}

TEST(Optimize, AMeshOverOtherPointsIsToldByTheirNumber) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n4 0\n4 3\n");
  const std::string mesh =
      folder.write("m.off", "OFF\n4 2 0\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n3 0 1 2\n3 0 2 3\n");
  for (const char* verb : {"optimize", "verify"}) {
    const Ended ended = tribunal({verb, points, mesh});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("m.off: holds 4 vertices, but"), std::string::npos) << ended.err;
  }
}

}  // namespace
}  // namespace tribunal::cli
