// Laws of Lawson's algorithm (Barth, section 3.3d): from every start, in every order, it ends in a Delaunay
// triangulation; each flip makes the angles better and lowers the lifted surface; no edge returns; convexity
// need not be asked.
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/list.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/triangulate.hpp"
#include "tests/flips/support.hpp"

#include <set>

namespace tribunal::flips {
namespace {

/// A criterion that is watched: `watch` is told of every flip, before and after.
template <class Watch>
class Watched {
 public:
  static constexpr bool implies_convexity = true;
  static constexpr int reach = 1;
  Watched(const Sites& sites, Watch watch) : criterion_(sites), watch_(watch) {}
  bool improves(const EdgeMesh& mesh, Index edge) {
    const bool better = criterion_.improves(mesh, edge);
    if (better) before_ = quadrilateral(mesh, edge);
    return better;
  }
  void flipped(const EdgeMesh&, Index) { watch_(before_); }

 private:
  DelaunayCriterion criterion_;
  Watch watch_;
  Quadrilateral before_{};
};

std::vector<Triangle> before(const Quadrilateral& q) {
  return {{q.from, q.to, q.left}, {q.to, q.from, q.right}};
}
std::vector<Triangle> after(const Quadrilateral& q) {
  return {{q.right, q.left, q.from}, {q.left, q.right, q.to}};
}

/// Flips a bad start of random integer points, half of them on a small grid with many ties.
template <class Watch>
void watch_flips(std::uint64_t seed, Watch watch) {
  Random random(seed);
  const Plane plane(integer_points(60, seed % 2 == 0 ? 8 : 1000, random));
  EdgeMesh mesh(start_triangulation(plane.sites(), plane.vertices, Start::fan));
  Watched criterion(plane.sites(), [&](const Quadrilateral& q) { watch(plane.points, q); });
  const FlipCounts counts = flip_to_optimum(plane.sites(), mesh, criterion, {});
  EXPECT_GT(counts.flips, 20U);
  EXPECT_EQ(fault_of(plane.points, mesh.triangles(), verify::Kind::delaunay), "");
}

TEST(Lawson, EndsInADelaunayTriangulationFromEveryStartInEveryOrder) {
  for (const Dataset& dataset : datasets()) {
    const Plane plane(dataset.generate(60, 2));
    if (!plane.usable) continue;
    for (const Start start : {Start::sweep, Start::fan, Start::halves})
      for (const std::uint64_t scrambled : {0, 10})
        for (const Method method : {Method::stack, Method::sweeps})
          for (const Scan scan : {Scan::ascending, Scan::descending, Scan::shuffled}) {
            if (method == Method::stack && scan != Scan::ascending) continue;
            const PlanarProblem problem{plane.points, plane.vertices, plane.sites().kernel};
            const Triangulation t =
                triangulate_by_flips<DelaunayCriterion>(problem, {start, scrambled, method, scan, 7});
            ASSERT_EQ(fault_of(plane.points, t.triangles, verify::Kind::delaunay), "") << dataset.about.name;
          }
  }
}

/// In general position the fixpoint is the one Delaunay triangulation (L2).
TEST(Lawson, GivesTheTriangulationOfAnInsertion) {
  const Plane plane(find_dataset("uniform")->generate(400, 11));
  const Sites sites = plane.sites();
  const Triangulation inserted =
      triangulate(plane.points, plane.vertices, sites.kernel, *find_planar_algorithm("bowyer"));
  for (const Start start : {Start::sweep, Start::fan, Start::halves}) {
    const PlanarProblem problem{plane.points, plane.vertices, sites.kernel};
    const Triangulation flipped =
        triangulate_by_flips<DelaunayCriterion>(problem, {.start = start, .random_flips = 5});
    EXPECT_EQ(canonical(flipped.triangles), canonical(inserted.triangles));
    EXPECT_EQ(flipped.hull, inserted.hull);
  }
}

/// L1: the least of the six angles grows, so that all angles in ascending order grow lexicographically.
TEST(Lawson, EveryFlipRaisesTheSmallestAngle) {
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    watch_flips(seed, [](const auto& points, const Quadrilateral& q) {
      ASSERT_LT(angles_of(points, before(q)).front(), angles_of(points, after(q)).front());
    });
}

/// L3: hence there are at most as many flips as pairs of points.
TEST(Lawson, NoRemovedEdgeReturns) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    std::set<std::pair<Index, Index>> removed;
    watch_flips(seed, [&](const auto&, const Quadrilateral& q) {
      ASSERT_TRUE(removed.insert(std::minmax(q.from, q.to)).second) << "removed twice";
      ASSERT_FALSE(removed.contains(std::minmax(q.left, q.right))) << "returned";
    });
  }
}

/// L5: twice the area under the triangles, lifted to x^2 + y^2, times three.
TEST(Lawson, EveryFlipLowersTheLiftedSurface) {
  const auto volume = [](const std::vector<Point2>& p, const std::vector<Triangle>& triangles) {
    std::int64_t sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const auto x = [&](Index v) { return static_cast<std::int64_t>(p[v][0]); };
      const auto y = [&](Index v) { return static_cast<std::int64_t>(p[v][1]); };
      const auto lift = [&](Index v) { return x(v) * x(v) + y(v) * y(v); };
      const std::int64_t area = (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
      EXPECT_GT(area, 0);
      sum += area * (lift(a) + lift(b) + lift(c));
    }
    return sum;
  };
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    watch_flips(seed, [&](const auto& points, const Quadrilateral& q) {
      ASSERT_LT(volume(points, after(q)), volume(points, before(q)));
    });
}

/// L4: all pairs of triangles across an edge, on a 4 x 4 grid: those that are not strictly convex, straight
/// angles included, never violate the circle test.
TEST(Lawson, NonconvexQuadrilateralsNeverViolateTheCircleTest) {
  std::vector<Point2> grid;
  for (int i = 0; i < 16; ++i) grid.push_back({double(i % 4), double(i / 4)});
  const Plane plane(grid, "gmp");
  const Sites sites = plane.sites();
  int nonconvex = 0, straight = 0;
  for (Index a = 0; a < 16; ++a)
    for (Index b = 0; b < 16; ++b)
      for (Index left = 0; left < 16; ++left)
        for (Index right = 0; right < 16; ++right) {
          if (sites.orient(a, b, left) != Sign::positive || sites.orient(b, a, right) != Sign::positive)
            continue;
          if (is_strictly_convex(sites, {a, b, left, right})) continue;
          ++nonconvex;
          straight += sites.orient(left, a, right) == Sign::zero;
          ASSERT_NE(sites.incircle(a, b, left, right), Sign::positive);
        }
  EXPECT_GT(nonconvex, 1000);
  EXPECT_GT(straight, 100);
}

/// L8: a criterion that takes ties for violations, on the unit square.
class TiesToo {
 public:
  static constexpr bool implies_convexity = true;
  static constexpr int reach = 1;
  explicit TiesToo(const Sites& sites) : sites_(sites) {}
  bool improves(const EdgeMesh& mesh, Index edge) const {
    const Quadrilateral q = quadrilateral(mesh, edge);
    return sites_.incircle(q.from, q.to, q.left, q.right) != Sign::negative;
  }

 private:
  Sites sites_;
};

TEST(Lawson, NeverEndsWhereTiesAreFlipped) {
  const Plane square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EdgeMesh mesh(start_triangulation(square.sites(), square.vertices, Start::sweep));
  TiesToo ties(square.sites());
  FlipEngine engine(square.sites(), mesh, ties, 100000);
  EXPECT_THROW(engine.flip_in_sweeps(Scan::ascending), Abandon);
  EXPECT_EQ(engine.counts().flips, 100000U);
}

TEST(Lawson, LeavesFixedEdges) {
  Random random(9);
  const Plane plane(integer_points(60, 1000, random));
  const auto start = start_triangulation(plane.sites(), plane.vertices, Start::sweep);
  EdgeMesh mesh(start);
  const EdgeMesh untouched(start);
  std::vector<char> fixed(mesh.edges(), 0);
  for (Index e = 0; e < mesh.edges(); e += 3) fixed[e] = 1;
  DelaunayCriterion delaunay(plane.sites());
  flip_to_optimum(plane.sites(), mesh, delaunay, {}, fixed);
  for (Index e = 0; e < mesh.edges(); ++e) {
    if (fixed[e] != 0) {
      ASSERT_EQ(mesh.from(2 * e), untouched.from(2 * e));
      ASSERT_EQ(mesh.to(2 * e), untouched.to(2 * e));
    } else if (mesh.is_inner(e)) {
      ASSERT_FALSE(delaunay.improves(mesh, e));
    }
  }
}

/// What is not exact may fail, but ends and says how.
TEST(Lawson, WrongSignsEnd) {
  for (const std::string_view backend : {"double", "float", "knuth-as-printed"})
    for (const std::string_view name : {"rotated-grid", "near-collinear", "kettner", "near-circle"})
      for (const Start start : {Start::sweep, Start::fan, Start::halves}) {
        const Plane plane(find_dataset(name)->generate(150, 1), backend);
        if (!plane.usable) continue;
        try {
          const PlanarProblem problem{plane.points, plane.vertices, plane.sites().kernel};
          triangulate_by_flips<DelaunayCriterion>(problem, {.start = start});
        } catch (const Abandon& abandon) {
          EXPECT_NE(std::string(abandon.what()), "");
        }
      }
}

}  // namespace
}  // namespace tribunal::flips
