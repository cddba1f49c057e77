// Files with segments: triangulated, verified, and refused where they are to blame.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

namespace tribunal::cli {
namespace {

const char* const square_with_hole =
    "8 2 0 0\n0 0 0\n1 8 0\n2 8 8\n3 0 8\n4 3 3\n5 5 3\n6 5 5\n7 3 5\n"
    "8 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 5 6\n6 6 7\n7 7 4\n1\n0 4 4\n";
const char* const square_with_ring = "POLYGON((0 0,8 0,8 8,0 8,0 0),\n(3 3,5 3,5 5,3 5,3 3))";
const char* const cross = "4 2 0 0\n0 0 0\n1 3 1\n2 0 1\n3 3 0\n2 0\n0 0 1\n1 2 3\n0\n";

std::vector<std::string> constrained(const std::string& file, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"triangulate", file, "--algorithm", "constrained", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Without segments there is no domain but the hull, for both verbs, and no hole.
TEST(Segments, AGraphWithoutSegmentsIsItsHull) {
  const Folder folder;
  const std::string square = folder.write(
                        "a.poly",
                        "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n"),
                    points = folder.write("b.poly", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n0 0\n0\n"),
                    hole = folder.write("c.poly", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n0 0\n1\n0 0.2 0.2\n"),
                    mesh = folder / "m.ele", beside = folder / "m.poly";
  for (const std::string& file : {square, points}) {
    ASSERT_EQ(tribunal({"triangulate", file, "--algorithm", "constrained", "-o", mesh}).status, 0);
    for (const std::string& graph : {file, beside}) {
      const Ended ended = tribunal({"verify", graph, mesh, "--kind", "constrained"});
      EXPECT_EQ(ended.status, 0) << graph << ended.out << ended.err;
    }
  }
  const Ended refused = tribunal({"triangulate", hole, "--algorithm", "constrained"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("c.poly:7: a hole, but"), std::string::npos) << refused.err;
}

TEST(Segments, DomainsFollowFromTheFile) {
  const Folder folder;
  for (const auto& [file, domain] : {std::pair(folder.write("a.poly", square_with_hole), "carved"),
                                     std::pair(folder.write("a.wkt", square_with_ring), "even-odd")}) {
    const Ended ended = tribunal(constrained(file));
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto stats = nlohmann::json::parse(ended.out);
    EXPECT_EQ(stats["triangles"], 8);
    EXPECT_EQ(stats["segments"]["domain"], domain);
    EXPECT_EQ(stats["segments"]["pieces"], 8);
    const Ended hull = tribunal(constrained(file, {"--set", "domain=hull"}));
    EXPECT_EQ(nlohmann::json::parse(hull.out)["triangles"], 10);
  }
}

TEST(Segments, MeshesVerifyFromTheirFiles) {
  const Folder folder;
  const std::string file = folder.write("a.poly", square_with_hole), mesh = folder / "m.ele";
  for (const std::string backend : {"gmp", "filtered", "knuth64"}) {
    ASSERT_EQ(
        tribunal(constrained(file, {"-o", mesh, "--backend", backend, "--picture", folder / "m.svg"})).status,
        0);
    EXPECT_EQ(tribunal({"verify", file, mesh, "--kind", "constrained"}).status, 0);
    EXPECT_EQ(tribunal({"verify", folder / "m.poly", mesh, "--kind", "constrained"}).status, 0);
    const Ended other =
        tribunal({"verify", file, mesh, "--kind", "constrained", "--domain", "hull", "--json"});
    EXPECT_EQ(other.status, 1);
    EXPECT_EQ(nlohmann::json::parse(other.out)["kind"], "constrained");
  }
  EXPECT_NE(read(folder / "m.svg").find("stroke-linecap"), std::string::npos);
}

TEST(Segments, CrossingsAreRefusedOrSplit) {
  const Folder folder;
  const std::string file = folder.write("a.poly", cross), mesh = folder / "m.ele";
  const Ended refused =
      tribunal({"triangulate", file, "--algorithm", "constrained", "--set", "domain=hull", "-o", mesh});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.one_line_error());
  EXPECT_EQ(
      refused.err.rfind("tribunal: " + file +
                            ":8: this segment, (0, 1) to (3, 0), crosses that of line 7, (0, 0) to (3, 1)",
                        0),
      0U)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(mesh));
  const Ended split =
      tribunal(constrained(file, {"--set", "domain=hull", "--set", "crossings=split", "-o", mesh}));
  ASSERT_EQ(split.status, 0) << split.err;
  const auto segments = nlohmann::json::parse(split.out)["segments"];
  EXPECT_EQ(segments["segments"], 2);
  EXPECT_EQ(segments["pieces"], 4);
  EXPECT_EQ(segments["crossing_points"], 1);
  EXPECT_EQ(segments["rounded"], 0);
  EXPECT_EQ(tribunal({"verify", folder / "m.poly", mesh, "--kind", "constrained", "--domain", "hull"}).status,
            0);
}

struct Blamed {
  const char *name, *text, *place;
};

TEST(Segments, BadFilesAreRefusedWithTheirPlace) {
  const Folder folder;
  for (const Blamed& bad : {
           Blamed{"outside.poly", "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 3 3\n",
                  ":10: hole 0 lies outside"},
           Blamed{"on.poly", "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 2 2\n",
                  ":10: hole 0 lies on"},
           Blamed{"open.poly", "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n2 0\n0 0 1\n1 1 2\n0\n",
                  ":2: a loop is open at this point"},
           Blamed{"length.poly", "2 2 0 0\n0 0 0\n1 4 0\n1 0\n0 1 1\n0\n", ":5:5: a segment without length"},
           Blamed{"nan.poly", "2 2 0 0\n0 0 0\n1 nan 0\n1 0\n0 0 1\n0\n", ":3:3: x is"},
           Blamed{"open.wkt", "POLYGON((0 0,4 0,0 4))", ":1:9: an open ring"},
           Blamed{"eight.wkt", "POLYGON((0 0,4 4,4 0,0 4,0 0))",
                  ":1: this segment, (4, 0) to (0, 4), crosses that of line 1, (0, 0)"},
           Blamed{"flat.wkt", "POLYGON((0 0,4 4,2 2,0 0))", ": all points lie on one line"},
       }) {
    const std::string file = folder.write(bad.name, bad.text), mesh = folder / "mesh.off";
    const Ended ended = tribunal({"triangulate", file, "--algorithm", "constrained", "-o", mesh});
    EXPECT_EQ(ended.status, 2) << bad.name << ended.err;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
    EXPECT_EQ(ended.err.rfind("tribunal: " + file + bad.place, 0), 0U) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(mesh)) << bad.name;
  }
}

TEST(Segments, TheGraphBesideAMeshKeepsItsDomain) {
  const Folder folder;
  const std::string file = folder.write("ring.wkt", square_with_ring), mesh = folder / "m.ele";
  for (const std::string domain : {"even-odd", "hull"}) {
    ASSERT_EQ(tribunal(constrained(file, {"-o", mesh, "--set", "domain=" + domain})).status, 0);
    EXPECT_EQ(tribunal({"verify", folder / "m.poly", mesh, "--kind", "constrained"}).status, 0) << domain;
  }
}

TEST(Segments, DomainsAndFlipsWantWhatTheyGet) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n4 0\n4 3\n0 3\n"), mesh = folder / "m.off";
  const std::string graph = folder.write("g.poly", square_with_hole);
  ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"triangulate", points, "--algorithm", "constrained", "--set", "domain=even-odd"},
           {"verify", points, mesh, "--domain", "hull"},
           {"optimize", graph, mesh}}) {
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2) << testing::PrintToString(words);
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
}

TEST(Segments, AHoleThatABackendCannotTellIsRefusedWithItsPlace) {
  const Folder folder;
  std::string off_lattice = square_with_hole;
  off_lattice.replace(off_lattice.rfind("4 4"), 3, "4.5 4");
  const std::string file = folder.write("a.poly", off_lattice);
  const Ended ended = tribunal(constrained(file, {"--backend", "knuth64"}));
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "tribunal: " + file + ":20: hole 0 is outside the backend's domain\n");
}

TEST(Segments, AreNotLostUnasked) {
  const Folder folder;
  const std::string file = folder.write("a.poly", square_with_hole);
  const Ended ended = tribunal({"triangulate", file});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_EQ(
      tribunal({"verify", folder.write("a.xy", "0 0\n1 0\n0 1\n"), file, "--kind", "constrained"}).status, 2);
  EXPECT_EQ(tribunal({"triangulate", file, "--algorithm", "constrained", "-o", folder / "a.ele"}).status, 2);
}

}  // namespace
}  // namespace tribunal::cli
