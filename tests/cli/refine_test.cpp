// refine, from boundary to mesh: outputs, statistics, and what is to blame where there is none.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace tribunal::cli {
namespace {

const char* const frame =
    "8 2 0 0\n0 0 0\n1 8 0\n2 8 8\n3 0 8\n4 3 3\n5 5 3\n6 5 5\n7 3 5\n"
    "8 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 5 6\n6 6 7\n7 7 4\n1\n0 4 4\n";

/// Rounded splits bend a boundary that is not parallel to an axis: what is written must still be judged
/// right.
TEST(Refine, WhatItWritesOfAHullIsVerified) {
  const Folder folder;
  const std::string lines = folder.write("h.wkt", "POINT(0 1)\nLINESTRING(0 0,3 1)\n");
  const std::string hole =
      folder.write("g.poly",
                   "# domain hull\n4 2 0 0\n0 0 0\n1 3 1\n2 2 3\n3 0 1\n4 0\n0 0 1\n1 1 2\n"
                   "2 2 3\n3 3 0\n1\n0 1 1\n");
  for (const std::string& file : {lines, hole})
    for (const char* size : {"size=0.9", "size=0.3", "size=0.1"}) {
      ASSERT_EQ(tribunal({"refine", file, "--set", size, "-o", folder / "h.ele"}).status, 0);
      const Ended verified =
          tribunal({"verify", folder / "h.poly", folder / "h.ele", "--kind", "constrained"});
      EXPECT_EQ(verified.status, 0) << file << verified.out;
    }
}

TEST(Refine, WritesAMeshThatVerifies) {
  const Folder folder;
  const std::string boundary = folder.write("frame.poly", frame), mesh = folder / "mesh.ele";
  const Ended ended = tribunal({"refine", boundary, "--set", "size=0.5", "-o", mesh, "--picture",
                                folder / "mesh.svg", "--stats", folder / "mesh.json", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto stats = nlohmann::json::parse(ended.out);
  EXPECT_EQ(stats["outcome"], "ok");
  EXPECT_GE(stats["angles"]["smallest"].get<double>(), 29.999);
  EXPECT_LE(stats["angles"]["largest"].get<double>(), 120.001);
  EXPECT_GT(stats["counts"]["splits"].get<int>(), 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "mesh.svg"));
  EXPECT_EQ(tribunal({"verify", folder / "mesh.poly", mesh, "--kind", "constrained"}).status, 0);
}

TEST(Refine, RefusesInOneLineAndWritesNothing) {
  const Folder folder;
  const std::string boundary = folder.write("frame.poly", frame);
  const std::string open = folder.write("open.poly", "3 2 0 0\n0 0 0\n1 8 0\n2 8 8\n2 0\n0 0 1\n1 1 2\n0\n");
  const std::string outside =
      folder.write("outside.poly", "3 2 0 0\n0 0 0\n1 8 0\n2 8 8\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 9 9\n");
  const std::string points = folder.write("points.xy", "0 0\n1 0\n0 1\n");
  const std::string mesh = folder / "mesh.ele";
  for (const auto& [file, setting] :
       {std::pair(boundary, "size=0"), std::pair(boundary, "size=-1"), std::pair(boundary, "size=nan"),
        std::pair(boundary, "size=x +"), std::pair(boundary, "angle=60"), std::pair(boundary, "angle=steep"),
        std::pair(boundary, "vertices=9"), std::pair(boundary, "size=x - 4"), std::pair(open, "angle=30"),
        std::pair(outside, "angle=30"), std::pair(points, "angle=30")}) {
    const Ended ended = tribunal({"refine", file, "--set", setting, "-o", mesh});
    EXPECT_EQ(ended.status, 2) << file << ' ' << setting;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(mesh));
  }
  EXPECT_NE(tribunal({"refine", outside}).err.find("outside.poly:10:"), std::string::npos);
}

struct BadPolygon {
  const char *name, *text, *place;
};

TEST(Refine, PolygonsThatBoundNothing) {
  const Folder folder;
  for (const BadPolygon& bad : {
           BadPolygon{"pinch.wkt", "POLYGON((0 0,4 0,4 4,\n2 2,0 4,1 3,\n2 2,0 0))",
                      ":2: a ring touches itself"},
           BadPolygon{"tee.wkt", "POLYGON((0 0,4 0,\n4 4,2 0,0 4,0 0))", ":2: a ring touches itself"},
           BadPolygon{"spike.wkt", "POLYGON((0 0,4 0,4 4,\n6 6,4 4,0 4,0 0))", ":1: a ring touches itself"},
           BadPolygon{"away.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0),\n(7 1,8 1,8 2,7 1))",
                      ":2: at this point an inner ring is not inside"},
           BadPolygon{"around.geojson",
                      R"({"type":"Polygon","coordinates":[[[1,1],[2,1],[1,2],[1,1]],
                      [[0,0],[5,0],[0,5],[0,0]]]})",
                      ":2: at this point an inner ring is not inside"},
       }) {
    const std::string file = folder.write(bad.name, bad.text), mesh = folder / "mesh.off";
    const Ended ended = tribunal({"refine", file, "-o", mesh});
    EXPECT_EQ(ended.status, 2) << bad.name << ended.err;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
    EXPECT_EQ(ended.err.rfind("tribunal: " + file + bad.place, 0), 0U) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(mesh)) << bad.name;
  }
  for (const char* good :
       {"POLYGON((0 0,4 0,4 4,0 4,0 0),(0 0,2 1,1 2,0 0))",  // the rings touch in a point
        "POLYGON((0 0,8 0,8 8,0 8,0 0),(1 1,7 1,7 7,1 7,1 1));POLYGON((2 2,6 2,6 6,2 6,2 2))",
        "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((4 0,8 0,8 4,4 4,4 0)))"}) {
    const Ended ended = tribunal({"refine", folder.write("good.wkt", good)});
    EXPECT_EQ(ended.status, 0) << good << ended.err;
  }
}

TEST(Refine, AnInputIsNotOverwrittenByAFileThatGoesBesideTheMesh) {
  const Folder folder;
  const std::string boundary = folder / "gulf.poly";
  ASSERT_EQ(tribunal({"points", "gulf", "-o", boundary}).status, 0);
  const Ended ended = tribunal({"refine", boundary, "-o", folder / "gulf.ele"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("gulf.node, which goes beside"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace tribunal::cli
