// What the writers write reads back to the same bits, and a file is replaced whole or not at all.
#include "datasets/files/files.hpp"
#include "datasets/random.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tribunal {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Limits = std::numeric_limits<double>;

/// Doubles that careless writers lose: zeros of both signs, subnormals, 17 digits, both ends of the range;
/// then 20,000 random bit patterns.
std::vector<Point2> hostile_points() {
  const std::array<double, 14> edges{
      0.0,        -0.0,         Limits::denorm_min(), -Limits::denorm_min(),    Limits::min(), 0.1,
      1.0 / 3,    0.1 + 0.2,    std::nextafter(1, 2), -2.2250738585072011e-308, 1e22,          1e23,
      0x1p53 + 2, Limits::max()};
  std::vector<Point2> points;
  for (const double x : edges)
    for (const double y : edges) points.push_back({{x, -y}});
  Random random(1);
  while (points.size() < 10000) {
    const Point2 p{{std::bit_cast<double>(random.bits()), std::bit_cast<double>(random.bits())}};
    if (std::isfinite(p[0]) && std::isfinite(p[1])) points.push_back(p);
  }
  return points;
}

void expect_same_bits(std::span<const Point2> got, std::span<const Point2> expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i)
    for (const std::size_t axis : {0, 1})
      ASSERT_EQ(std::bit_cast<std::uint64_t>(got[i][axis]), std::bit_cast<std::uint64_t>(expected[i][axis]))
          << "point " << i << ": " << got[i][axis] << " for " << expected[i][axis];
}

TEST(Writing, PointsReadBackToTheSameBitsInEveryFormat) {
  const test::Folder folder;
  const auto points = hostile_points();
  for (const FormatAbout& format : formats()) {
    if (format.holds.find("points") == std::string_view::npos) continue;
    const auto path = folder / std::string("a").append(format.name);
    write_points(path, points);
    const PointFile file = read_points(path);
    expect_same_bits(file.points, points);
    EXPECT_EQ(file.lines.size(), points.size());
  }
}

TEST(Writing, HexadecimalAsPrintedByOthersReadsBackToTheSameBits) {
  const test::Folder folder;
  const auto points = hostile_points();
  std::string content;
  for (const Point2& p : points) {
    std::array<char, 80> line{};
    const int length = std::snprintf(line.data(), line.size(), "%a %A\n", p[0], p[1]);
    content.append(line.data(), static_cast<std::size_t>(length));
  }
  expect_same_bits(read_points(folder.write("a.xy", content)).points, points);
}

TEST(Writing, MeshesReadBackTheSameInEveryFormat) {
  const test::Folder folder;
  const auto points = hostile_points();
  const Triangles triangles{{0, 1, 2}, {9999, 5, 0}, {3, 3, 3}};
  write_mesh(folder / "a.off", points, triangles);
  const MeshFile off = read_mesh(folder / "a.off");
  expect_same_bits(off.points, points);
  EXPECT_EQ(off.triangles, triangles);

  write_mesh(folder / "b.ele", points, triangles);
  EXPECT_EQ(read_mesh(folder / "b.ele", points.size()).triangles, triangles);
  expect_same_bits(read_points(folder / "b.node").points, points);
}

TEST(Writing, FilesLookAsDocumented) {
  const test::Folder folder;
  const std::vector<Point2> points{{{0, -0.5}}, {{1e30, 2}}};
  const Triangles triangles{{0, 1, 0}};
  for (const std::string_view name : {"a.xy", "a.xyz", "a.csv", "a.node", "a.off"})
    write_points(folder / name, points);
  EXPECT_EQ(folder.read("a.xy"), "0 -0.5\n1e+30 2\n");
  EXPECT_EQ(folder.read("a.xyz"), "0 -0.5 0\n1e+30 2 0\n");
  EXPECT_EQ(folder.read("a.csv"), "x,y\n0,-0.5\n1e+30,2\n");
  EXPECT_EQ(folder.read("a.node"), "2 2 0 0\n0 0 -0.5\n1 1e+30 2\n");
  EXPECT_EQ(folder.read("a.off"), "OFF\n2 0 0\n0 -0.5 0\n1e+30 2 0\n");
  write_mesh(folder / "b.off", points, triangles);
  write_mesh(folder / "b.ele", points, triangles);
  EXPECT_EQ(folder.read("b.off"), "OFF\n2 1 0\n0 -0.5 0\n1e+30 2 0\n3 0 1 0\n");
  EXPECT_EQ(folder.read("b.ele"), "1 3 0\n0 0 1 0\n");
  EXPECT_EQ(folder.read("b.node"), folder.read("a.node"));
}

TEST(Writing, ReplacesTheOldContentAndLeavesNothingElse) {
  const test::Folder folder;
  folder.write("a.xy", std::string(100000, 'x'));
  write_points(folder / "a.xy", std::vector<Point2>{{{1, 2}}});
  EXPECT_EQ(folder.read("a.xy"), "1 2\n");
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Writing, FollowsALinkInsteadOfReplacingIt) {
  const test::Folder folder;
  folder.write("target.xy", "0 0\n");
  std::filesystem::create_symlink("target.xy", folder / "link.xy");
  write_points(folder / "link.xy", std::vector<Point2>{{{1, 2}}});
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.xy"));
  EXPECT_EQ(folder.read("target.xy"), "1 2\n");
}

TEST(Writing, FormatsAreListedWithWhatTheyHold) {
  std::vector<std::string_view> names;
  for (const FormatAbout& format : formats()) {
    names.push_back(format.name);
    EXPECT_FALSE(format.summary.empty());
  }
  EXPECT_EQ(names, (std::vector<std::string_view>{".xy", ".xyz", ".csv", ".node", ".ele", ".off", ".poly",
                                                  ".geojson", ".wkt"}));
}

}  // namespace
}  // namespace tribunal
