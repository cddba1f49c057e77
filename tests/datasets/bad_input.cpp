// Every bad input is refused in one line that names the file, the line and the column.
#include "datasets/files/files.hpp"
#include "tests/datasets/support.hpp"

namespace tribunal {
namespace {

/// The refusal's text without the folder in front of the file's name.
template <class Read>
std::string refusal(const test::Folder& folder, Read read) {
  try {
    read();
  } catch (const BadInput& error) {
    const std::string text = error.what();
    const std::string prefix = (folder / "").string();
    EXPECT_TRUE(text.starts_with(prefix)) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text.substr(std::min(prefix.size(), text.size()));
  }
  return "accepted";
}

struct Case {
  std::string name, content, expected;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.expected; }

class BadPoints : public ::testing::TestWithParam<Case> {};
TEST_P(BadPoints, AreRefusedWithTheirPlace) {
  const test::Folder folder;
  const auto path = folder.write(GetParam().name, GetParam().content);
  EXPECT_EQ(refusal(folder, [&] { read_points(path); }), GetParam().expected);
}

class BadMesh : public ::testing::TestWithParam<Case> {};
TEST_P(BadMesh, IsRefusedWithItsPlace) {
  const test::Folder folder;
  const auto path = folder.write(GetParam().name, GetParam().content);
  EXPECT_EQ(refusal(folder, [&] { read_mesh(path, 4); }), GetParam().expected);
}

const std::string binary(
    "\x7F"
    "ELF\x02\x01\0\0 \xFF\n",
    11);

INSTANTIATE_TEST_SUITE_P(
    Columns, BadPoints,
    ::testing::ValuesIn(std::vector<Case>{
        {"a.xy", "", "a.xy: no points"},
        {"a.xy", "\n  \n# nothing\n", "a.xy: no points"},
        {"a.xy", "hello world\n", "a.xy:1:1: x is \"hello\", not a number"},
        {"a.xy", "1 2\n3 four\n", "a.xy:2:3: y is \"four\", not a number"},
        {"a.xy", "1 2\nnan 4\n", "a.xy:2:1: x is \"nan\", not finite"},
        {"a.xy", "1 -inf\n", "a.xy:1:3: y is \"-inf\", not finite"},
        {"a.xy", "1 1e999\n", "a.xy:1:3: y is \"1e999\", outside the range of doubles"},
        {"a.xy", "1 -1e-999\n", "a.xy:1:3: y is \"-1e-999\", outside the range of doubles"},
        {"a.xy", "0x1p1024 1\n", "a.xy:1:1: x is \"0x1p1024\", outside the range of doubles"},
        {"a.xy", "1 0x\n", "a.xy:1:3: y is \"0x\", not a number"},
        {"a.xy", "1 0x-1\n", "a.xy:1:3: y is \"0x-1\", not a number"},
        {"a.xy", "+-1 2\n", "a.xy:1:1: x is \"+-1\", not a number"},
        {"a.xy", "--1 2\n", "a.xy:1:1: x is \"--1\", not a number"},
        {"a.xy", "1,2\n", "a.xy:1:1: x is \"1,2\", not a number"},
        {"a.xy", "1 2\n7\n", "a.xy:2:2: y is missing"},
        {"a.xy", "7 # 8\n", "a.xy:1:3: y is missing"},
        {"a.xy", "1 2 3\n4 5\n", "a.xy:2:4: 2 columns, but 3 in line 1"},
        {"a.xy", "# c\n1 2\r\n4 5 6\r\n", "a.xy:3:5: 3 columns, but 2 in line 2"},
        {"a.xy", "1 2 3 4\n", "a.xy:1:7: \"4\" follows the last column"},
        {"a.xyz", "1 2 nan\n", "a.xyz:1:5: the third column is \"nan\", not finite"},
        {"a.xy", binary, "a.xy:1: a zero byte: this is no text"},
        {"a.xy", "1 2\n3 4\n" + std::string(1 << 17, '5') + std::string(1, '\0'),
         "a.xy:3: a zero byte: this is no text"},
        {"a.xy", "1 2\n\x7F\xFF 1\n", "a.xy:2:1: x is \"\\x7f\\xff\", not a number"},
        {"a.xy", "1 2\n" + std::string(1000000, '7') + "x 1\n",
         "a.xy:2:1: x is \"777777777777777777777777...\", not a number"},
        {"a.xy", "1 2\n" + std::string(1000000, '7') + " 1\n",
         "a.xy:2:1: x is \"777777777777777777777777...\", outside the range of doubles"},
    }));

INSTANTIATE_TEST_SUITE_P(
    Csv, BadPoints,
    ::testing::ValuesIn(std::vector<Case>{
        {"a.csv", "", "a.csv: no points"},
        {"a.csv", "x,y\n", "a.csv: no points"},
        {"a.csv", "nan,1\n", "a.csv:1:1: x is \"nan\", not finite"},
        {"a.csv", "inf,Infinity\n", "a.csv:1:1: x is \"inf\", not finite"},
        {"a.csv", "id,x,y\n1,2,3\n", "a.csv:1:4: x is column 2, but is read from column 1"},
        {"a.csv", "Y,X\n1,2\n", "a.csv:1:3: x is column 2, but is read from column 1"},
        {"a.csv", "x,z,y\n1,2,3\n", "a.csv:1:5: y is column 3, but is read from column 2"},
        {"a.csv", "x,y\n1,2,3\n", "a.csv:1:1: 2 names for 3 columns"},
        {"a.csv", "lon,lat,depth\n1,2\n", "a.csv:1:1: 3 names for 2 columns"},
        {"a.csv", "x,y\nx,y\n", "a.csv:2:1: x is \"x\", not a number"},
        {"a.csv", "x,2\n", "a.csv:1:1: x is \"x\", not a number"},
        {"a.csv", "1\n", "a.csv:1:2: y is missing"},
        {"a.csv", "\"y\",\"x\"\n1,2\n", "a.csv:1:5: x is column 2, but is read from column 1"},
        {"a.csv", "1,\"2\n", "a.csv:1:3: y is \"\"2\", not a number"},
        {"a.csv", "\"1,2\"\n", "a.csv:1:1: x is \"1,2\", not a number"},
        {"a.csv", "1,\n", "a.csv:1:3: y is empty"},
        {"a.csv", "1,2\n , 4\n", "a.csv:2:1: x is empty"},
        {"a.csv", "1;2\n", "a.csv:1:1: x is \"1;2\", not a number"},
        {"a.csv", "1, two\n", "a.csv:1:4: y is \"two\", not a number"},
        {"a.csv", "1,2,3\n4,5\n", "a.csv:2:4: 2 columns, but 3 in line 1"},
        {"a.csv", "1,2,3,4\n", "a.csv:1:7: \"4\" follows the last column"},
    }));

INSTANTIATE_TEST_SUITE_P(
    Node, BadPoints,
    ::testing::ValuesIn(std::vector<Case>{
        {"a.node", "", "a.node: no points"},
        {"a.node", "0 2 0 0\n", "a.node:1:1: no points"},
        {"a.node", "x 2 0 0\n", "a.node:1:1: the number of points is \"x\", not a count"},
        {"a.node", "-3 2 0 0\n", "a.node:1:1: the number of points is \"-3\", not a count"},
        {"a.node", "1 3 0 0\n", "a.node:1:3: the dimension must be 2"},
        {"a.node", "1 2 0 2\n", "a.node:1:7: the number of markers must be 0 or 1"},
        {"a.node", "1 2 0 0 9\n", "a.node:1:9: \"9\" follows the last column"},
        {"a.node", "2000000000 2 0 0\n0 1 2\n1 3 4\n2 5 6\n",
         "a.node:1: 2000000000 points announced, 3 found"},
        {"a.node", "18446744073709551615 2 0 0\n0 1 2\n",
         "a.node:1: 18446744073709551615 points announced, 1 found"},
        {"a.node", "1 2 18446744073709551615 0\n0 1 2 3\n", "a.node:2:8: an attribute is missing"},
        {"a.node", "# c\n1 2 0 0\n1 1 2\n2 3 4\n", "a.node:4: more than the 1 points announced in line 2"},
        {"a.node", "1 2 0 0\n2 3 4\n", "a.node:2:1: items are numbered from 0 or 1, not from 2"},
        {"a.node", "2 2 0 0\n1 3 4\n3 3 4\n", "a.node:3:1: number 3 where 2 is next"},
        {"a.node", "1 2 0 0\n1 3\n", "a.node:2:4: y is missing"},
        {"a.node", "1 2 0 0\n1 3 nan\n", "a.node:2:5: y is \"nan\", not finite"},
        {"a.node", "1 2 0 1\n1 3 4\n", "a.node:2:6: the marker is missing"},
        {"a.node", "1 2 0 0\n1 3 4 5\n", "a.node:2:7: \"5\" follows the last column"},
    }));

INSTANTIATE_TEST_SUITE_P(Off, BadPoints,
                         ::testing::ValuesIn(std::vector<Case>{
                             {"a.off", "", "a.off: no points"},
                             {"a.off", "OFF\n0 0 0\n", "a.off: no points"},
                             {"a.off", "COFF\n1 0 0\n", "a.off:1:1: OFF expected, found \"COFF\""},
                             {"a.off", "OFF\n", "a.off:1:4: the number of vertices is missing"},
                             {"a.off", "OFF\n4\n", "a.off:2:2: the number of faces is missing"},
                             {"a.off", "OFF\n2 0 0\n1 2 0\n", "a.off:2: 2 vertices announced, 1 found"},
                             {"a.off", "OFF\n1 0 0\n1 2\n", "a.off:3:4: z is missing"},
                             {"a.off", "OFF\n1 0 0\n1 inf 2\n", "a.off:3:3: y is \"inf\", not finite"},
                         }));

INSTANTIATE_TEST_SUITE_P(
    Ele, BadMesh,
    ::testing::ValuesIn(std::vector<Case>{
        {"a.ele", "", "a.ele: no header"},
        {"a.ele", "1 6 0\n", "a.ele:1:3: triangles must have 3 nodes"},
        {"a.ele", "1 3 0\n0 0 1 4\n", "a.ele:2:7: vertex 4 is outside 0..3"},
        {"a.ele", "1 3 0\n1 1 2 5\n", "a.ele:2:7: vertex 5 is outside 1..4"},
        {"a.ele", "1 3 0\n1 0 1 2\n", "a.ele:2:3: vertex 0 is outside 1..4"},
        {"a.ele", "1 3 0\n0 -1 1 2\n", "a.ele:2:3: vertex -1 is outside 0..3"},
        {"a.ele", "1 3 0\n0 0 1.5 2\n", "a.ele:2:5: a vertex is \"1.5\", not an integer"},
        {"a.ele", "1 3 0\n0 0 1 99999999999999999999\n",
         "a.ele:2:7: a vertex is \"99999999999999999999\", not an integer"},
        {"a.ele", "1 3 0\n0 0 1\n", "a.ele:2:6: a vertex is missing"},
        {"a.ele", "1 3 0\n0 0 1 2 3\n", "a.ele:2:9: \"3\" follows the last column"},
        {"a.ele", "3000000000 3 0\n0 0 1 2\n", "a.ele:1: 3000000000 triangles announced, 1 found"},
        {"a.ele", "1 3 0\n0 0 1 2\n1 0 1 3\n", "a.ele:3: more than the 1 triangles announced in line 1"},
    }));

INSTANTIATE_TEST_SUITE_P(
    Off, BadMesh,
    ::testing::ValuesIn(std::vector<Case>{
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off:6:7: vertex 3 is outside 0..2"},
        {"a.off", "OFF\n0 1 0\n3 0 1 2\n", "a.off:3:3: vertex 0 of a mesh without points"},
        {"a.off", "OFF\n1 1 0\n0 0 0\n4 0 0 0 0\n",
         "a.off:4:1: a face with 4 corners, only triangles are read"},
        {"a.off", "OFF\n1 2 0\n0 0 0\n3 0 0 0\n", "a.off:2: 2 faces announced, 1 found"},
        {"a.off", "OFF\n1 0 0\n0 0 0\n3 0 0 0\n", "a.off:4: more than the 0 faces announced in line 2"},
    }));

TEST(BadPaths, AreRefusedWithTheSystemsReason) {
  const test::Folder folder;
  folder.write("file.xy", "1 2\n");
  std::filesystem::create_directory(folder / "folder.xy");
  const auto reading = [&](const char* name) { return refusal(folder, [&] { read_points(folder / name); }); };
  EXPECT_EQ(reading("none.xy"), "none.xy: cannot read: No such file or directory");
  EXPECT_EQ(reading("folder.xy"), "folder.xy: cannot read: Is a directory");
  EXPECT_EQ(reading("file.xy/a.xy"), "file.xy/a.xy: cannot read: Not a directory");
  EXPECT_EQ(reading("file"),
            "file: no format for points has the ending \"\", there are .xy .xyz .csv .node .off .poly "
            ".geojson .wkt");
  EXPECT_EQ(reading("file.ele"),
            "file.ele: no format for points has the ending \".ele\", there are .xy .xyz .csv .node .off "
            ".poly .geojson .wkt");
  EXPECT_EQ(refusal(folder, [&] { read_mesh(folder / "a.xy"); }),
            "a.xy: no format for meshes has the ending \".xy\", there are .ele .off");
}

TEST(BadPaths, AreRefusedWhenWriting) {
  const test::Folder folder;
  const std::vector<Point2> points(1000, Point2{{1, 2}});
  std::filesystem::create_directory(folder / "folder.xy");
  std::filesystem::create_symlink("/dev/full", folder / "full.xy");
  const auto writing = [&](const char* name) {
    return refusal(folder, [&] { write_points(folder / name, points); });
  };
  EXPECT_EQ(writing("none/a.xy"), "none/a.xy: cannot write: No such file or directory");
  EXPECT_EQ(writing("folder.xy"), "folder.xy: cannot write: Is a directory");
  EXPECT_EQ(writing("full.xy"), "full.xy: cannot write: No space left on device");
  EXPECT_EQ(writing("a.txt"),
            "a.txt: no format for points has the ending \".txt\", there are .xy .xyz .csv .node .off .poly "
            ".geojson .wkt");
  EXPECT_EQ(folder.files(), 2U);
}

}  // namespace
}  // namespace tribunal
