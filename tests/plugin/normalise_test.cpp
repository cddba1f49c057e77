// Freedom that outsiders have is taken out of meshes before the checker sees them, and nothing else is.
#include "bench/normalise.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tribunal::bench {
namespace {

using Triangles = std::vector<Triangle>;

TEST(Normalise, TurnsClockwiseTrianglesAndUsesFirstCopies) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}, {{1, 0}}, {{-0.0, 1}}};
  EXPECT_EQ(normalise(points, {{0, 2, 1}}), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(normalise(points, {{4, 0, 3}}), (Triangles{{0, 1, 2}}));
}

TEST(Normalise, TurnsByExactSigns) {
  // On Kettner's grid the rounded area of these is zero; the exact one is positive.
  const std::vector<Point2> points{{{12, 12}}, {{24, 24}}, {{0.5, 0.5 + 0x1p-53}}};
  EXPECT_EQ(normalise(points, {{1, 0, 2}}), normalise(points, {{0, 1, 2}}));
  EXPECT_EQ(normalise(points, {{1, 0, 2}}), (Triangles{{0, 1, 2}}));
}

TEST(Normalise, LeavesFaultsToTheChecker) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 1}}};
  EXPECT_EQ(normalise(points, {{7, 2, 1}}), (Triangles{{1, 7, 2}}));
  EXPECT_EQ(normalise(points, {{2, 1, 0}}), (Triangles{{0, 2, 1}})) << "flat";
  EXPECT_EQ(normalise(points, {{0, 1, 3}}), (Triangles{{0, 1, 1}})) << "two copies of one point";
  EXPECT_EQ(normalise({}, {}), Triangles{});
}

}  // namespace
}  // namespace tribunal::bench
