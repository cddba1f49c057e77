// Laws of quantise().
#include "datasets/dataset.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribunal {
namespace {

std::vector<Point2> sample(std::string_view name) { return find_dataset(name)->generate(500, 3); }

double high(std::span<const Point2> points, std::size_t axis) {
  double most = 0;
  for (const Point2& p : points) most = std::max(most, p[axis]);
  return most;
}

class EveryLength : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Bits, EveryLength, ::testing::Values(1, 2, 14, 30, 31, 32, 51, 52, 53));

TEST_P(EveryLength, GivesIntegersOfTheLatticeWhoseLongerSideIsFilled) {
  const double last = std::ldexp(1.0, GetParam()) - 1;
  for (const std::string_view name : {"uniform", "normal", "spiral", "kettner", "mixed-exponents", "coast"}) {
    const auto lattice = quantise(sample(name), GetParam());
    ASSERT_EQ(lattice.size(), 500U);
    for (const Point2& p : lattice) {
      for (const double c : p.coordinate) {
        ASSERT_TRUE(0 <= c && c <= last && c == std::floor(c)) << name;
        ASSERT_FALSE(std::signbit(c));
      }
    }
    EXPECT_EQ(std::max(high(lattice, 0), high(lattice, 1)), last) << name;
  }
}

TEST_P(EveryLength, IsIdempotent) {
  for (const std::string_view name : {"uniform", "normal", "spiral", "near-circle", "counties"}) {
    const auto once = quantise(sample(name), GetParam());
    EXPECT_EQ(quantise(once, GetParam()), once) << name;
  }
}

TEST_P(EveryLength, KeepsTheOrderAlongEachAxis) {
  const auto points = sample("normal");
  const auto lattice = quantise(points, GetParam());
  for (std::size_t i = 1; i < points.size(); ++i)
    for (const std::size_t axis : {0, 1})
      ASSERT_TRUE(points[i - 1][axis] > points[i][axis] || lattice[i - 1][axis] <= lattice[i][axis]);
}

TEST(Quantise, KeepsShapesByOneScaleForBothAxes) {
  std::vector<Point2> points{{{-1, 10}}, {{3, 11}}, {{1, 12}}};  // a box of 4 x 2
  EXPECT_EQ(quantise(points, 10), (std::vector<Point2>{{{0, 0}}, {{1023, 256}}, {{512, 512}}}));
  for (Point2& p : points) std::swap(p[0], p[1]);
  EXPECT_EQ(quantise(points, 10), (std::vector<Point2>{{{0, 0}}, {{256, 1023}}, {{512, 512}}}));
}

TEST(Quantise, SendsAPointAndEqualPointsToTheOrigin) {
  EXPECT_TRUE(quantise(std::vector<Point2>{}, 8).empty());
  EXPECT_EQ(quantise(std::vector<Point2>{{{7, -3}}}, 8), (std::vector<Point2>{{{0, 0}}}));
  EXPECT_EQ(quantise(std::vector<Point2>(3, Point2{{1e300, 5e-324}}), 8),
            (std::vector<Point2>(3, Point2{{0, 0}})));
}

TEST(Quantise, TakesBoxesAsWideAsDoublesAndAsNarrow) {
  constexpr double most = std::numeric_limits<double>::max();
  const std::vector<Point2> lattice{{{0, 0}}, {{255, 255}}, {{128, 128}}};
  EXPECT_EQ(quantise(std::vector<Point2>{{{-most, -most}}, {{most, most}}, {{0, 0}}}, 8), lattice);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(quantise(std::vector<Point2>{{{0, -0.0}}, {{2 * least, 2 * least}}, {{least, least}}}, 8),
            lattice);
}

}  // namespace
}  // namespace tribunal
