// What the readers accept, and what they make of it.
#include "datasets/files/announced.hpp"
#include "datasets/files/files.hpp"
#include "tests/datasets/support.hpp"

namespace tribunal {
namespace {

using Points = std::vector<Point2>;
using Lines = std::vector<std::uint64_t>;
using Values = std::vector<double>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

PointFile points_of(std::string_view name, std::string_view content) {
  const test::Folder folder;
  return read_points(folder.write(name, content));
}
MeshFile mesh_of(std::string_view name, std::string_view content) {
  const test::Folder folder;
  return read_mesh(folder.write(name, content));
}

TEST(Reading, XyTakesBlanksTabsCommentsEmptyLinesAndNoFinalNewline) {
  const auto file = points_of("a.xy", "# head\n\n 1 2\n\t3\t4  # tail\n   \n5 6");
  EXPECT_EQ(file.points, (Points{{{1, 2}}, {{3, 4}}, {{5, 6}}}));
  EXPECT_EQ(file.lines, (Lines{3, 4, 6}));
  EXPECT_TRUE(file.values.empty());
}

TEST(Reading, LinesMayEndAsOnWindowsAndBeginWithAByteOrderMark) {
  const auto file = points_of("a.xy",
                              "\xEF\xBB\xBF"
                              "1 2\r\n3 4\r\n\r\n5 6\r\n");
  EXPECT_EQ(file.points, (Points{{{1, 2}}, {{3, 4}}, {{5, 6}}}));
  EXPECT_EQ(file.lines, (Lines{1, 2, 4}));
}

TEST(Reading, EndingsAreTheSameInCapitals) {
  EXPECT_EQ(points_of("A.XY", "1 2\n").points, (Points{{{1, 2}}}));
}

TEST(Reading, NumbersAreDecimalOrHexadecimalCorrectlyRounded) {
  const auto file =
      points_of("a.xy", "0x1.8p1 -0x1p-1074\n+1e+2 -.5\n1. 0X.8P0\n9007199254740993 4.9e-324\n");
  EXPECT_EQ(file.points,
            (Points{{{3, -0x1p-1074}}, {{100, -0.5}}, {{1, 0.5}}, {{9007199254740992.0, 0x1p-1074}}}));
}

TEST(Reading, DuplicatesStayWithTheirLines) {
  const auto file = points_of("a.xy", "1 2\n# x\n1 2\n1 2\n");
  EXPECT_EQ(file.points.size(), 3U);
  EXPECT_EQ(file.lines, (Lines{1, 3, 4}));
}

TEST(Reading, AThirdColumnIsTheValue) {
  for (const std::string_view name : {"a.xy", "a.xyz"}) {
    const auto file = points_of(name, "1 2 3\n4 5 6\n");
    EXPECT_EQ(file.points, (Points{{{1, 2}}, {{4, 5}}}));
    EXPECT_EQ(file.values, (Values{3, 6}));
  }
}

TEST(Reading, CsvTakesNamesInItsFirstLineOrNone) {
  for (const std::string_view head : {"", "x,y\n", "lon , lat\n", "\"x\",\"y\"\n", "# comment\n_x,y2\n"}) {
    const auto file = points_of("a.csv", std::string(head) + "1, 2\r\n 3 ,\t4\n");
    EXPECT_EQ(file.points, (Points{{{1, 2}}, {{3, 4}}})) << head;
  }
  EXPECT_EQ(points_of("a.csv", "x,y,height\n1,2,3").values, (Values{3}));
}

TEST(Reading, CsvFieldsMayBeQuotedAndThenHoldCommas) {
  const auto file = points_of("a.csv", "\"x\",\"y\",\"height, in m\"\n\"1\", \" 2\" ,3\n4,\"-5e1\",\"6\"\n");
  EXPECT_EQ(file.points, (Points{{{1, 2}}, {{4, -50}}}));
  EXPECT_EQ(file.values, (Values{3, 6}));
}

TEST(Reading, NodeCountsFromZeroOrOne) {
  for (const std::string_view content : {"2 2 0 0\n0 1 2\n1 3 4\n", "2 2 0 0\n1 1 2\n2 3 4\n",
                                         "2\n1 1 2\n2 3 4\n", "# head\n2 2 0 1\n\n0 1 2 -7\n1 3 4 0\n# end"})
    EXPECT_EQ(points_of("a.node", content).points, (Points{{{1, 2}}, {{3, 4}}})) << content;
}

TEST(Reading, FirstAttributeOfNodeIsTheValue) {
  const auto file = points_of("a.node", "2 2 2 1\n1 1 2 10 11 0\n2 3 4 20 21 1\n");
  EXPECT_EQ(file.values, (Values{10, 20}));
  EXPECT_EQ(file.lines, (Lines{2, 3}));
}

TEST(Reading, OffGivesPointsAndMesh) {
  for (const std::string_view head : {"OFF\n3 1 0\n", "OFF 3 1 3\n", "# x\nOFF # y\n3 1\n"}) {
    const std::string content = std::string(head) + "0 0 7\n1 0 8\n0 1 9\n3 0 1 2 255 0 0\n";
    EXPECT_EQ(points_of("a.off", content).points, (Points{{{0, 0}}, {{1, 0}}, {{0, 1}}}));
    EXPECT_EQ(points_of("a.off", content).values, (Values{7, 8, 9}));
    EXPECT_EQ(mesh_of("a.off", content).points, (Points{{{0, 0}}, {{1, 0}}, {{0, 1}}}));
    EXPECT_EQ(mesh_of("a.off", content).triangles, (Triangles{{0, 1, 2}}));
  }
}

TEST(Reading, PointsOfAnOffFileDoNotDependOnItsFaces) {
  EXPECT_EQ(points_of("a.off", "OFF\n1 1 0\n5 6 0\n4 0 0 0 0\n").points, (Points{{{5, 6}}}));
}

TEST(Reading, EleCountsVerticesFromWhereItCountsTriangles) {
  EXPECT_EQ(mesh_of("a.ele", "2 3 0\n0 0 1 2\n1 2 1 3\n").triangles, (Triangles{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(mesh_of("a.ele", "2 3 0\n1 1 2 3\n2 3 2 4\n").triangles, (Triangles{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(mesh_of("a.ele", "1 3 2\n1 1 2 3 0.5 7\n").triangles, (Triangles{{0, 1, 2}}));
}

TEST(Reading, MeshesMayHaveNoTriangles) {
  EXPECT_TRUE(mesh_of("a.ele", "0 3 0\n").triangles.empty());
  EXPECT_TRUE(mesh_of("a.off", "OFF\n1 0 0\n1 2 0\n").triangles.empty());
}

TEST(Reading, AnnouncedCountsAreBelievedOnlyAsFarAsTheTextGoes) {
  Scanner scanner("a.node", "2000000000 2 0 0\n0 1 2\n1 3 4\n2 5 6\n");
  ASSERT_TRUE(scanner.next_line());
  const files::Announced announced(scanner, "points");
  EXPECT_EQ(announced.count(), 2000000000U);
  EXPECT_LT(announced.plausible(scanner, 3), 10U);
  EXPECT_GE(announced.plausible(scanner, 3), 3U);
}

}  // namespace
}  // namespace tribunal
