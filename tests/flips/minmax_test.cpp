// Laws of MinMax triangulations (Barth, section 3.4): flips end in a local optimum, which need not be global;
// edge insertion gives the global one, as all triangulations of small sets and dynamic programming over
// convex polygons say.
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/flips/minmax_edge_insertion.hpp"
#include "algorithms/list.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/triangulate.hpp"
#include "tests/flips/support.hpp"

#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace tribunal::flips {
namespace {

IntegerAngle largest_angle(const std::vector<Point2>& points, const std::vector<Triangle>& triangles) {
  return angles_of(points, triangles).back();
}

/// The smallest largest angle of all triangulations there are: from any one flips lead to all others.
struct Exhaustive {
  IntegerAngle smallest;
  std::size_t triangulations;
};
Exhaustive search_all(const Plane& plane) {
  const auto first = canonical(start_triangulation(plane.sites(), plane.vertices, Start::sweep));
  std::set<std::vector<Triangle>> seen{first};
  std::deque<std::vector<Triangle>> waiting{first};
  std::optional<IntegerAngle> best;
  while (!waiting.empty()) {
    const auto triangles = waiting.front();
    waiting.pop_front();
    const IntegerAngle angle = largest_angle(plane.points, triangles);
    if (!best || angle < *best) best = angle;
    EdgeMesh mesh(triangles);
    for (Index edge = 0; edge < mesh.edges(); ++edge) {
      if (!mesh.is_inner(edge) || !is_strictly_convex(plane.sites(), quadrilateral(mesh, edge))) continue;
      mesh.flip(edge);
      if (auto flipped = canonical(mesh.triangles()); seen.insert(flipped).second) waiting.push_back(flipped);
      mesh.flip(edge);
    }
  }
  return {*best, seen.size()};
}

std::vector<Triangle> triangulated(const Plane& plane, std::string_view algorithm) {
  const Triangulation t =
      triangulate(plane.points, plane.vertices, plane.sites().kernel, *find_planar_algorithm(algorithm));
  EXPECT_EQ(t.outcome, Outcome::ok) << t.reason;
  return t.triangles;
}

/// Five to eight points, on grids where they line up and make ties, and off them.
TEST(MinMax, GlobalIsTheBestOfAllTriangulations) {
  Random random(1);
  std::size_t triangulations = 0, local_misses = 0;
  for (int round = 0; round < 150; ++round) {
    const Plane plane(integer_points(5 + random.below(4), round % 3 == 0 ? 4 : 40, random), "gmp");
    if (!plane.usable) continue;
    const Exhaustive all = search_all(plane);
    triangulations += all.triangulations;
    const auto global = triangulated(plane, "minmax-global"), local = triangulated(plane, "minmax-local");
    ASSERT_EQ(fault_of(plane.points, global), "");
    ASSERT_EQ(largest_angle(plane.points, global), all.smallest) << "round " << round;
    local_misses += all.smallest < largest_angle(plane.points, local);
  }
  EXPECT_GT(triangulations, 3000U);
  EXPECT_GT(local_misses, 0U) << "a local optimum is not always global: M2";
}

/// From bad starts, so that edges have to be inserted and cross many.
TEST(MinMax, EdgeInsertionFindsTheBestFromEveryStart) {
  Random random(2);
  std::uint64_t insertions = 0;
  for (int round = 0; round < 60; ++round) {
    const Plane plane(integer_points(8, round % 3 == 0 ? 4 : 40, random), "gmp");
    if (!plane.usable) continue;
    const IntegerAngle best = search_all(plane).smallest;
    for (const Start start : {Start::sweep, Start::fan, Start::halves}) {
      const auto result = insert_edges_for_min_max_angle(
          plane.sites(), start_triangulation(plane.sites(), plane.vertices, start));
      ASSERT_EQ(fault_of(plane.points, result.triangles), "");
      ASSERT_EQ(largest_angle(plane.points, result.triangles), best) << "round " << round;
      insertions += result.counts.insertions;
    }
  }
  EXPECT_GT(insertions, 60U);
}

/// Points of a convex polygon, counter-clockwise: directions (a, b) in order of their slopes, added up, and
/// back again the other way.
std::vector<Point2> convex_polygon(std::size_t half, Random& random) {
  std::vector<std::pair<int, int>> directions;
  while (directions.size() < half) {
    const int a = 1 + static_cast<int>(random.below(9)), b = static_cast<int>(random.below(19)) - 9;
    if (std::all_of(directions.begin(), directions.end(),
                    [&](const auto& d) { return d.first * b != d.second * a; }))
      directions.emplace_back(a, b);
  }
  std::sort(directions.begin(), directions.end(),
            [](const auto& c, const auto& d) { return c.second * d.first < d.second * c.first; });
  std::vector<Point2> points;
  int x = 0, y = 0;
  for (const int sign : {1, -1})
    for (const auto& [a, b] : directions) {
      points.push_back({double(x), double(y)});
      x += sign * a;
      y += sign * b;
    }
  return points;
}

/// The smallest largest angle over all triangulations of a convex polygon, sub-polygon by sub-polygon.
IntegerAngle best_of_convex_polygon(const std::vector<Point2>& p) {
  const std::size_t n = p.size();
  std::map<std::pair<std::size_t, std::size_t>, IntegerAngle> best;  // of the polygon i, i+1, ..., j
  for (std::size_t length = 2; length < n; ++length)
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      std::optional<IntegerAngle> smallest;
      for (std::size_t k = i + 1; k < j; ++k) {
        IntegerAngle worst = largest_angle(p, {{Index(i), Index(k), Index(j)}});
        if (k > i + 1) worst = std::max(worst, best.at({i, k}));
        if (j > k + 1) worst = std::max(worst, best.at({k, j}));
        if (!smallest || worst < *smallest) smallest = worst;
      }
      best.emplace(std::pair(i, j), *smallest);
    }
  return best.at({0, n - 1});
}

TEST(MinMax, GlobalIsTheBestOfConvexPolygons) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    const Plane plane(convex_polygon(4 + random.below(14), random), "gmp");
    const auto global = triangulated(plane, "minmax-global");
    ASSERT_EQ(fault_of(plane.points, global), "");
    ASSERT_EQ(largest_angle(plane.points, global), best_of_convex_polygon(plane.points)) << round;
  }
}

double degrees(const IntegerAngle& a) {
  return std::acos(static_cast<double>(a.dot) / std::sqrt(static_cast<double>(a.legs))) * 180 /
         std::numbers::pi;
}

/// M2, with its figures.
TEST(MinMax, ALocalOptimumNeedNotBeGlobal) {
  const Plane plane({{0, 3}, {0, 6}, {2, 0}, {11, 2}, {7, 11}}, "gmp");
  const std::vector<Triangle> stuck{{0, 2, 4}, {2, 3, 4}, {0, 4, 1}};
  EdgeMesh mesh(stuck);
  MinMaxCriterion criterion(plane.sites());
  EXPECT_EQ(flip_to_optimum(plane.sites(), mesh, criterion, {}).flips, 0U);
  EXPECT_NEAR(degrees(largest_angle(plane.points, stuck)), 125.538, 5e-4);
  EXPECT_NEAR(degrees(largest_angle(plane.points, triangulated(plane, "minmax-global"))), 111.161, 5e-4);
  EXPECT_NEAR(degrees(largest_angle(plane.points, triangulated(plane, "bowyer"))), 146.310, 5e-4);
}

std::uint64_t improving_flips(const Plane& plane, const std::vector<Triangle>& triangles) {
  const EdgeMesh mesh(triangles);
  const MinMaxCriterion criterion(plane.sites());
  std::uint64_t improving = 0;
  for (Index edge = 0; edge < mesh.edges(); ++edge)
    improving += mesh.is_inner(edge) && is_strictly_convex(plane.sites(), quadrilateral(mesh, edge)) &&
                 criterion.improves(mesh, edge);
  return improving;
}

/// M5 for insertion, and the same for flips; on all data a triangulation comes of it.
TEST(MinMax, LocalMethodsEndWithoutAnImprovingFlip) {
  for (const Dataset& dataset : datasets())
    for (const std::uint64_t n : {4, 30, 200}) {
      const Plane plane(dataset.generate(n, 4));
      if (!plane.usable) continue;
      for (const auto* algorithm : {"minmax-local", "green-sibson-minmax"}) {
        const auto triangles = triangulated(plane, algorithm);
        ASSERT_EQ(fault_of(plane.points, triangles), "") << dataset.about.name << " " << algorithm;
        ASSERT_EQ(improving_flips(plane, triangles), 0U) << dataset.about.name << " " << algorithm;
      }
    }
}

TEST(MinMax, GlobalIsATriangulationOfEveryDatasetAndNoWorseThanLocal) {
  for (const Dataset& dataset : datasets()) {
    const Plane plane(dataset.generate(50, 4));
    if (!plane.usable) continue;
    const auto global = triangulated(plane, "minmax-global"), local = triangulated(plane, "minmax-local");
    ASSERT_EQ(fault_of(plane.points, global), "") << dataset.about.name;
    const auto worst = [&](const std::vector<Triangle>& triangles) {
      Triangle largest = largest_corner(plane.sites(), triangles[0]);
      for (const Triangle& t : triangles) {
        const Triangle corner = largest_corner(plane.sites(), t);
        if (plane.sites().compare_angle(corner, largest) == Sign::positive) largest = corner;
      }
      return largest;
    };
    EXPECT_NE(plane.sites().compare_angle(worst(global), worst(local)), Sign::positive) << dataset.about.name;
  }
}

/// M1: the largest of the six angles falls, so that all angles in descending order fall lexicographically.
class WatchedMinMax {
 public:
  static constexpr bool implies_convexity = false;
  static constexpr int reach = 1;
  explicit WatchedMinMax(const Plane& plane) : plane_(plane), criterion_(plane.sites()) {}
  bool improves(const EdgeMesh& mesh, Index edge) {
    before_ = quadrilateral(mesh, edge);
    return criterion_.improves(mesh, edge);
  }
  void flipped(const EdgeMesh&, Index) {
    const auto& q = before_;
    ASSERT_LT(largest_angle(plane_.points, {{q.right, q.left, q.from}, {q.left, q.right, q.to}}),
              largest_angle(plane_.points, {{q.from, q.to, q.left}, {q.to, q.from, q.right}}));
  }

 private:
  const Plane& plane_;
  MinMaxCriterion criterion_;
  Quadrilateral before_{};
};

TEST(MinMax, EveryFlipLowersTheLargestAngle) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    const Plane plane(integer_points(60, seed % 2 == 0 ? 8 : 200, random));
    EdgeMesh mesh(start_triangulation(plane.sites(), plane.vertices, Start::fan));
    WatchedMinMax criterion(plane);
    EXPECT_GT(flip_to_optimum(plane.sites(), mesh, criterion, {}).flips, 20U);
  }
}

/// The largest corner of a triangle, by sides, is the one with the largest angle.
TEST(MinMax, TheLargestAngleIsAcrossFromTheLongestSide) {
  Random random(8);
  for (int round = 0; round < 500; ++round) {
    const Plane plane(integer_points(3, 6, random));
    if (!plane.usable) continue;
    const Sites sites = plane.sites();
    const Triangle t = sites.orient(0, 1, 2) == Sign::positive ? Triangle{0, 1, 2} : Triangle{0, 2, 1};
    const Triangle corner = largest_corner(sites, t);
    const auto& p = plane.points;
    EXPECT_EQ(IntegerAngle(p[corner[0]], p[corner[1]], p[corner[2]]), largest_angle(p, {t}));
  }
}

}  // namespace
}  // namespace tribunal::flips
