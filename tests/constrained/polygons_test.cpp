// Rings of polygons: what encloses what, against winding numbers in integers.
#include "algorithms/constrained/polygons.hpp"

#include "algorithms/constrained/constrained.hpp"
#include "datasets/dataset.hpp"
#include "datasets/random.hpp"
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace tribunal::constrained {
namespace {

/// Rings over points of their own.
struct RingsOfPoints {
  std::vector<Point2> points;
  std::vector<Edge> segments;
  std::vector<Index> ring, outer;

  void add(const std::vector<Point2>& corners, Index of) {
    const auto first = static_cast<Index>(points.size()), size = static_cast<Index>(corners.size());
    for (Index i = 0; i < size; ++i) {
      points.push_back(corners[i]);
      segments.push_back({first + i, first + (i + 1) % size});
      ring.push_back(static_cast<Index>(outer.size()));
    }
    outer.push_back(of);
  }

  /// Nothing where segments cross, or all are on one line.
  std::optional<std::optional<RingFault>> judge() const {
    const Graph graph{points, segments, {}, Domain::hull};
    const Kernel2Binding bound = find_backend("gmp")->bind2(points);
    const Kernel2& kernel = *std::get<0>(bound);
    const auto whole =
        triangulate_graph(graph, insertion_order(points, Order::input, 1), kernel, Recovery::cavity);
    if (whole.mesh.outcome != Outcome::ok || whole.mesh.dimension < 2) return std::nullopt;
    return find_ring_fault(graph, {ring, outer}, whole.touches, kernel);
  }
};

/// Cross products of small integers are exact.
double cross(Point2 a, Point2 b, Point2 p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}
bool on_segment(Point2 a, Point2 b, Point2 p) {
  return cross(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}
bool simple(const std::vector<Point2>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (j != i && j != (i + 1) % n && on_segment(ring[i], ring[(i + 1) % n], ring[j])) return false;
  return true;
}
int winding(const std::vector<Point2>& ring, Point2 p) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a[1] <= p[1] && b[1] > p[1] && cross(a, b, p) > 0) ++turns;
    if (a[1] > p[1] && b[1] <= p[1] && cross(a, b, p) < 0) --turns;
  }
  return turns;
}

std::vector<Point2> random_ring(Random& random, std::size_t size) {
  std::vector<Point2> ring;
  for (std::size_t i = 0; i < size; ++i)
    ring.push_back({{static_cast<double>(random.below(7)), static_cast<double>(random.below(7))}});
  return ring;
}

TEST(Polygons, RandomRingsAreJudgedAsByWindingNumbers) {
  Random random(5);
  int good = 0, touching = 0, outside = 0;
  for (int i = 0; i < 30'000; ++i) {
    const auto outer = random_ring(random, 3 + random.below(4)), inner = random_ring(random, 3);
    RingsOfPoints rings;
    rings.add(outer, 0);
    rings.add(inner, 0);
    const auto judged = rings.judge();
    if (!judged) continue;
    const bool touches = !simple(outer) || !simple(inner);
    if (touches) {
      ++touching;
      ASSERT_TRUE(*judged && (*judged)->kind == RingFault::Kind::touches_itself) << i;
      continue;
    }
    std::vector<Point2> free_corners;
    std::copy_if(inner.begin(), inner.end(), std::back_inserter(free_corners), [&](Point2 p) {
      for (std::size_t k = 0; k < outer.size(); ++k)
        if (on_segment(outer[k], outer[(k + 1) % outer.size()], p)) return false;
      return true;
    });
    const bool held = std::any_of(outer.begin(), outer.end(), [&](Point2 p) {
      for (std::size_t k = 0; k < inner.size(); ++k)
        if (on_segment(inner[k], inner[(k + 1) % inner.size()], p)) return false;
      return winding(inner, p) != 0;
    });
    const bool inside = !held && !free_corners.empty() &&
                        std::all_of(free_corners.begin(), free_corners.end(),
                                    [&](Point2 p) { return winding(outer, p) != 0; });
    ASSERT_EQ(judged->has_value(), !inside) << i;
    ++(inside ? good : outside);
  }
  EXPECT_GT(good, 50);
  EXPECT_GT(touching, 500);
  EXPECT_GT(outside, 500);
}

// Out through one corner of the outer ring and in through another, crossing nothing.
TEST(Polygons, InnerRingThatLeavesThroughCorners) {
  RingsOfPoints rings;
  rings.add({{{0, 0}}, {{4, 0}}, {{4, 2}}, {{4, 4}}, {{0, 4}}}, 0);
  rings.add({{{3, 3}}, {{4, 2}}, {{6, 3}}, {{4, 4}}}, 0);
  const auto judged = rings.judge();
  ASSERT_TRUE(judged && *judged);
  EXPECT_EQ((*judged)->kind, RingFault::Kind::outside_outer_ring);
  EXPECT_EQ(rings.points[(*judged)->point], (Point2{{6, 3}}));
}

// An edge between two corners of the outer ring across a bay, all else inside.
TEST(Polygons, InnerRingAcrossABay) {
  RingsOfPoints rings;
  rings.add({{{0, 0}}, {{6, 0}}, {{6, 6}}, {{4, 6}}, {{3, 3}}, {{2, 6}}, {{0, 6}}}, 0);
  rings.add({{{2, 6}}, {{4, 6}}, {{3, 1}}}, 0);
  const auto judged = rings.judge();
  ASSERT_TRUE(judged && *judged);
  EXPECT_EQ((*judged)->kind, RingFault::Kind::outside_outer_ring);
  EXPECT_EQ(rings.points[(*judged)->point], (Point2{{3, 3}}));
}

// Many holes in a ring of many corners: some inside, one in a bay.
TEST(Polygons, ManyHoles) {
  RingsOfPoints rings;
  std::vector<Point2> comb;
  for (int tooth = 0; tooth < 500; ++tooth)
    comb.insert(comb.end(), {{{4.0 * tooth, 100}}, {{4.0 * tooth + 2, 1}}});
  comb.insert(comb.end(), {{{2000, 100}}, {{2000, 0}}, {{0, 0}}});
  std::reverse(comb.begin(), comb.end());
  rings.add(comb, 0);
  for (int hole = 0; hole < 499; ++hole) {
    const double x = 4.0 * hole + 4, y = 10 + hole % 60;
    rings.add({{{x, y}}, {{x + 0.25, y}}, {{x, y + 1}}}, 0);
  }
  const auto all_inside = rings.judge();
  ASSERT_TRUE(all_inside);
  EXPECT_FALSE(*all_inside);
  rings.add({{{402, 90}}, {{402.25, 90}}, {{402, 91}}}, 0);
  const auto judged = rings.judge();
  ASSERT_TRUE(judged && *judged);
  EXPECT_EQ((*judged)->kind, RingFault::Kind::outside_outer_ring);
  EXPECT_EQ(rings.points[(*judged)->point], (Point2{{402, 90}}));
}

}  // namespace
}  // namespace tribunal::constrained
