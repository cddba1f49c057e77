// Law: candidates come in the order of their exact lengths, whatever rounding, underflow and overflow make of
// the keys.
#include "algorithms/greedy/length_order.hpp"

#include "tests/greedy/support.hpp"

#include <gmpxx.h>

#include <cmath>

namespace tribunal::greedy {
namespace {

mpq_class exact_length(const std::vector<Point2>& points, const Edge& e) {
  const mpq_class x = mpq_class(points[e[0]][0]) - points[e[1]][0],
                  y = mpq_class(points[e[0]][1]) - points[e[1]][1];
  return x * x + y * y;
}

void expect_exact_order(const std::vector<Point2>& points, std::string_view backend) {
  const Plane plane(points, backend);
  ASSERT_TRUE(plane.is_bound());
  const PlanarProblem problem = plane.problem();
  const LengthOrder order(problem);
  std::vector<Candidate> candidates;
  for (Index a = 0; a < points.size(); ++a)
    for (Index b = a + 1; b < points.size(); ++b) candidates.push_back(order.candidate(b, a));
  std::vector<Edge> expected;
  for (const Candidate& c : candidates) expected.push_back(c.ends);
  std::vector<std::pair<mpq_class, Edge>> keyed;
  for (const Edge& e : expected) keyed.emplace_back(exact_length(points, e), e);
  std::sort(keyed.begin(), keyed.end());
  order.sort(candidates);
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    ASSERT_EQ(candidates[i].ends, keyed[i].second) << i;
    if (i > 0) {
      EXPECT_TRUE(order(candidates[i - 1], candidates[i]));
      EXPECT_FALSE(order(candidates[i], candidates[i - 1]));
    }
  }
}

TEST(LengthOrder, TiesOfAGridComeByIndex) {
  std::vector<Point2> points;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y) points.push_back({double(x), double(y)});
  expect_exact_order(points, "filtered");
  expect_exact_order(points, "gmp");
}

/// Lengths that differ in their last bits or not at all: keys alone would order many of them wrongly.
TEST(LengthOrder, NearlyEqualLengths) {
  Random random(3);
  std::vector<Point2> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = random.unit() * 6.28;
    points.push_back({0.1 + std::cos(angle), 0.1 + std::sin(angle)});
    points.push_back({0.1 - std::cos(angle), 0.1 - std::sin(angle)});
  }
  expect_exact_order(points, "filtered");
}

TEST(LengthOrder, FromTheSmallestToTheLargestDoubles) {
  Random random(5);
  std::vector<Point2> points{{0x1p1023, 0x1.fp1023}, {-0x1p1023, -0x1p1023}, {0, 0x1p-1074}, {0x1p-1074, 0}};
  for (int i = 0; i < 50; ++i) {
    const auto coordinate = [&] {
      return std::ldexp(random.unit() - 0.5, static_cast<int>(random.below(2040)) - 1030);
    };
    points.push_back({coordinate(), coordinate()});
  }
  expect_exact_order(points, "gmp");
}

TEST(LengthOrder, AroundTheUnderflowOfSquares) {
  Random random(6);
  std::vector<Point2> points;
  for (int i = 0; i < 60; ++i)
    points.push_back({std::ldexp(random.unit(), -530 - static_cast<int>(random.below(12))),
                      std::ldexp(random.unit(), -530 - static_cast<int>(random.below(12)))});
  expect_exact_order(points, "filtered");
}

}  // namespace
}  // namespace tribunal::greedy
