// The shipped data are what their description says.
#include "datasets/dataset.hpp"
#include "datasets/real.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal {
namespace {
using test::distinct;
using test::orient;

std::vector<Point2> counties() { return find_dataset("counties")->generate(83767, 1); }
std::vector<Point2> coast() { return find_dataset("coast")->generate(850, 1); }

double longest(std::span<const Point2> points) {
  double most = 0;
  for (const Point2& p : points) most = std::max({most, p[0], p[1]});
  return most;
}

TEST(Counties, Are83767PointsOfWhich33416AreDistinct) {
  const auto points = counties();
  EXPECT_EQ(points.size(), 83767U);
  EXPECT_EQ(distinct(points), 33416U);
}

TEST(Counties, LieOnALatticeOf17Bits) {
  for (const Point2& p : counties())
    for (const double c : p.coordinate) ASSERT_TRUE(c >= 0 && c == std::floor(c));
  EXPECT_EQ(longest(counties()), 99999);
  EXPECT_LT(longest(counties()), 0x1p17);
  EXPECT_GE(longest(counties()), 0x1p14);  // more than backends of 14 bits admit
}

TEST(Counties, HoldCollinearRuns) {
  const auto points = counties();
  int runs = 0;
  for (std::size_t i = 2; i < points.size(); ++i)
    if (distinct(std::span(points).subspan(i - 2, 3)) == 3 &&
        orient(points[i - 2], points[i - 1], points[i]) == 0)
      ++runs;
  EXPECT_EQ(runs, 92);  // of three distinct consecutive points
}

TEST(Coast, Is850DistinctPointsOf13BitsThatTouchBothAxes) {
  const auto points = coast();
  EXPECT_EQ(points.size(), 850U);
  EXPECT_EQ(distinct(points), 850U);
  EXPECT_LT(longest(points), 0x1p13);
  for (const std::size_t axis : {0, 1})
    EXPECT_EQ(std::ranges::min(points, {}, [&](const Point2& p) { return p[axis]; })[axis], 0);
}

TEST(Coast, SegmentsJoinDistinctPointsOnceAndMakePaths) {
  const auto segments = coast_segments();
  EXPECT_EQ(segments.size(), 847U);
  std::set<std::array<std::uint32_t, 2>> seen;
  std::vector<int> degree(850);
  for (const auto& [a, b] : segments) {
    ASSERT_LT(a, b);
    ASSERT_LT(b, 850U);
    EXPECT_TRUE(seen.insert({a, b}).second);
    ++degree[a];
    ++degree[b];
  }
  for (const int d : degree) EXPECT_TRUE(1 <= d && d <= 2);
}

TEST(Coast, SegmentsMeetOnlyAtTheirEnds) {
  const auto points = coast();
  const auto segments = coast_segments();
  const auto sign = [](test::Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
  const auto side = [&](const std::array<std::uint32_t, 2>& s, std::uint32_t v) {
    return sign(orient(points[s[0]], points[s[1]], points[v]));
  };
  for (const auto& s : segments) {
    for (std::uint32_t v = 0; v < points.size(); ++v)
      ASSERT_FALSE(v != s[0] && v != s[1] && side(s, v) == 0 &&
                   strictly_between(points[s[0]], points[v], points[s[1]]));
    for (const auto& t : segments)
      ASSERT_FALSE(side(s, t[0]) * side(s, t[1]) < 0 && side(t, s[0]) * side(t, s[1]) < 0);
  }
}

}  // namespace
}  // namespace tribunal
