// Bad files: status 2, one line that names file and line, nothing written.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

namespace tribunal::cli {
namespace {

struct BadFile {
  const char *name, *text;
  const char* place;  ///< what follows the file's name in the message
};

const BadFile bad_points[] = {
    {"empty.xy", "", ""},
    {"comments.xy", "# nothing\n\n", ""},
    {"text.xy", "0 0\n1 one\n", ":2:"},
    {"nan.xy", "0 0\n1 0\nnan 1\n", ":3:"},
    {"inf.csv", "0,0\n1,0\n0,-inf\n", ":3:"},
    {"one_column.xy", "0 0\n1\n", ":2:"},
    {"ragged.csv", "0,0\n1,0\n0,1,2,3\n", ":3:"},
    {"overflow.xy", "0 0\n1e999 0\n", ":2:"},
    {"announced.node", "2000000000 2 0 0\n0 0 0\n1 1 0\n2 0 1\n", ""},
    {"nonsense.node", "three 2 0 0\n", ":1:"},
    {"short.off", "OFF\n3 1 0\n0 0 0\n", ""},
    {"unknown.docx", "0 0\n", ""},
};

TEST(BadInput, PointFiles) {
  const Folder folder;
  for (const BadFile& bad : bad_points) {
    const std::string path = folder.write(bad.name, bad.text), mesh = folder / "mesh.off";
    const Ended ended = tribunal({"triangulate", path, "-o", mesh});
    EXPECT_EQ(ended.status, 2) << bad.name << ": " << ended.err;
    EXPECT_TRUE(ended.one_line_error()) << bad.name << "\n" << ended.err;
    EXPECT_EQ(ended.err.rfind("tribunal: " + path + bad.place, 0), 0U) << ended.err;
    EXPECT_TRUE(ended.out.empty()) << bad.name;
    EXPECT_FALSE(std::filesystem::exists(mesh)) << bad.name;
  }
}

TEST(BadInput, UnreadablePaths) {
  const Folder folder;
  for (const std::string& path : {folder / "absent.xy", folder / ""}) {
    const Ended ended = tribunal({"triangulate", path});
    EXPECT_EQ(ended.status, 2) << path;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
}

TEST(BadInput, MeshIndexOutOfRange) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n1 0\n0 1\n");
  const std::string mesh = folder.write("m.ele", "2 3 0\n0 0 1 2\n1 0 1 3\n");
  const Ended ended = tribunal({"verify", points, mesh});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error());
  EXPECT_EQ(ended.err.rfind("tribunal: " + mesh + ":3", 0), 0U) << ended.err;
}

TEST(BadInput, PlanWithAnUnknownKey) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml",
                                        "name = \"x\"\n[[cells]]\nalgorithm = \"bowyer\"\nbackend = \"gmp\"\n"
                                        "dataset = \"grid\"\nn = 10\ncolour = \"red\"\n");
  const Ended ended = tribunal({"run", plan, "-o", folder / "out"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
  EXPECT_EQ(ended.err.rfind("tribunal: " + plan + ":7:", 0), 0U) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace tribunal::cli
