// refine: from a dataset's boundary to a mesh that the checker accepts.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

namespace tribunal::cli {
namespace {

struct Wing {
  Folder folder;
  std::string poly = folder / "wing.poly", mesh = folder / "mesh.ele", mesh_poly = folder / "mesh.poly";
  Wing() { EXPECT_EQ(tribunal({"points", "aerofoil", "-n", "132", "-o", poly}).status, 0); }
};

TEST(RefineStretched, MakesAMeshThatIsRightButForItsCircles) {
  const Wing wing;
  const Ended ended = tribunal(
      {"refine", wing.poly, "--algorithm", "stretched", "--set", "wall=1e-3", "-o", wing.mesh, "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto stats = ended.json();
  EXPECT_EQ(stats["vertices"], 132 + stats["counts"]["inserted"].get<int>());
  EXPECT_LT(stats["angles"]["largest"], 150);
  EXPECT_EQ(
      tribunal({"verify", wing.mesh_poly, wing.mesh, "--kind", "constrained", "--criterion", "none"}).status,
      0);
  EXPECT_EQ(tribunal({"verify", wing.mesh_poly, wing.mesh, "--kind", "constrained"}).status, 1)
      << "stretched triangles are not Delaunay";
}

TEST(RefineStretched, RefusesSpacingsThatAreNone) {
  const Wing wing;
  for (const char* wall : {"wall=0", "wall=-1e-4", "wall=nan", "growth=0.5", "wall=2e300"}) {
    const Ended ended =
        tribunal({"refine", wing.poly, "--algorithm", "stretched", "--set", wall, "-o", wing.mesh});
    EXPECT_EQ(ended.status, 2) << wall;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
  EXPECT_EQ(tribunal({"verify", wing.poly, wing.mesh, "--kind", "constrained"}).status, 2)
      << "nothing is written";
}

TEST(RefineAdaptive, FollowsAFormula) {
  const Folder folder;
  const std::string square = folder.write(
      "square.poly", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  const std::string mesh = folder / "mesh.ele";
  const Ended ended = tribunal({"refine", square, "--algorithm", "adaptive", "--set", "field=shock", "--set",
                                "tolerance=0.05", "-o", mesh, "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_GT(ended.json()["vertices"], 100);
  EXPECT_EQ(tribunal({"verify", folder / "mesh.poly", mesh, "--kind", "constrained"}).status, 0);
}

TEST(RefineAdaptive, ReadsTheFieldOfThePoints) {
  const Folder folder;
  const std::string square = folder.write(
      "square.poly", "4 2 1 0\n0 0 0 1\n1 1 0 1\n2 1 1 5\n3 0 1 5\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  const Ended ended =
      tribunal({"refine", square, "--algorithm", "adaptive", "--set", "tolerance=0.1", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_GT(ended.json()["vertices"], 20);
}

TEST(RefineAdaptive, RefusesFieldsThatAreNoNumbersOrNotThere) {
  const Folder folder;
  const std::string points = "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";
  const std::string square = folder.write("square.poly", points);
  const std::string nan = folder.write(
      "nan.poly", "4 2 1 0\n0 0 0 1\n1 1 0 nan\n2 1 1 5\n3 0 1 5\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  for (const auto& [file, field] : {std::pair{square, "field=values"},
                                    {square, "field=log(x-2)"},
                                    {square, "field=shocks"},
                                    {nan, "field=values"}}) {
    const Ended ended = tribunal({"refine", file, "--algorithm", "adaptive", "--set", field});
    EXPECT_EQ(ended.status, 2) << field;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
}

TEST(Points, WriteDomainsWithTheirSegments) {
  const Folder folder;
  for (const char* bits : {"0", "24"}) {
    const std::string poly = folder / (std::string("d") + bits + ".poly"), mesh = folder / "m.ele";
    ASSERT_EQ(tribunal({"points", "high-lift", "-n", "200", "--bits", bits, "-o", poly}).status, 0);
    EXPECT_EQ(tribunal({"triangulate", poly, "--algorithm", "constrained", "-o", mesh}).status, 0);
    EXPECT_EQ(tribunal({"verify", poly, mesh, "--kind", "constrained"}).status, 0);
  }
}

}  // namespace
}  // namespace tribunal::cli
