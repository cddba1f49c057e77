// Which segments are walls, and the ways that lead away from their vertices.
#include "algorithms/stretching/walls.hpp"

#include "tests/stretching/support.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tribunal::stretching {
namespace {
using test::polygon;
using test::Sample;

TEST(Walls, AreTheInnerLoops) {
  const Sample sample(find_dataset("high-lift")->graph(352, 1));
  const auto built = sample.mesh();
  const Boundary boundary = boundary_of(built.mesh, WallChoice::inner);
  EXPECT_EQ(boundary.rim.size(), 32U) << "the box";
  EXPECT_EQ(boundary.walls.size(), sample.data.segments.size() - 32);
  EXPECT_EQ(boundary_of(built.mesh, WallChoice::all).walls.size(), sample.data.segments.size());
}

TEST(Walls, AreTheOuterLoopWhereThereIsNoOther) {
  const Sample sample(polygon({{{0, 0}}, {{4, 0}}, {{4, 4}}, {{0, 4}}}));
  const Boundary boundary = boundary_of(sample.mesh().mesh, WallChoice::inner);
  EXPECT_EQ(boundary.walls.size(), 4U);
  EXPECT_TRUE(boundary.rim.empty());
}

/// The ways from the corner at the origin of a polygon, in degrees.
std::vector<double> degrees_at_origin(std::vector<Point2> others) {
  others.insert(others.begin(), {{0, 0}});
  const Sample sample(polygon(others));
  const auto built = sample.mesh();
  std::vector<double> degrees;
  for (const Vector& way : ways_from(built.mesh, built.vertex[0])) {
    EXPECT_NEAR(std::hypot(way[0], way[1]), 1, 1e-15);
    degrees.push_back(std::atan2(way[1], way[0]) * 180 / std::acos(-1.0));
  }
  return degrees;
}

void expect_degrees(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
}

TEST(Ways, AreBisectorsInNarrowSectors) {
  expect_degrees(degrees_at_origin({{{4, 0}}, {{0, 4}}}), {45});
  expect_degrees(degrees_at_origin({{{4, 0}}, {{4, 4}}}), {22.5});
  expect_degrees(degrees_at_origin({{{4, 0}}, {{0, 4}}, {{-4, 0}}}), {90});  // on a straight wall
}

TEST(Ways, FanOutAroundSharpEdges) {
  // The domain is all but a sector to the right: a step of a right angle, and an edge of 2 atan 1/8.
  expect_degrees(degrees_at_origin({{{0, 4}}, {{-4, 4}}, {{-4, -4}}, {{4, -4}}, {{4, 0}}}), {180, -90});
  const std::vector<double> fan =
      degrees_at_origin({{{8, 1}}, {{8, 9}}, {{-8, 9}}, {{-8, -9}}, {{8, -9}}, {{8, -1}}});
  ASSERT_EQ(fan.size(), 3U);
  EXPECT_NEAR(fan[0], 90 + std::atan(0.125) * 180 / std::acos(-1.0), 1e-9) << "normal to the upper side";
  EXPECT_NEAR(std::abs(fan[1]), 180, 1e-9);
  EXPECT_NEAR(fan[2], -fan[0], 1e-9);
}

}  // namespace
}  // namespace tribunal::stretching
