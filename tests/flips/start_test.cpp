// Laws: a start is a triangulation of its points, whatever they are; random flips leave it one; a mesh put
// together from triangles knows their neighbours.
#include "algorithms/abandon.hpp"
#include "algorithms/mesh/assemble.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/mesh/splits.hpp"
#include "tests/flips/support.hpp"

namespace tribunal::flips {
namespace {

constexpr Start all_starts[] = {Start::sweep, Start::fan, Start::halves};

TEST(Start, IsATriangulationOfEveryDataset) {
  int meshes = 0;
  for (const Dataset& dataset : datasets())
    for (const std::uint64_t n : {3, 7, 40, 300})
      for (const Start start : all_starts) {
        const Plane plane(dataset.generate(n, 3));
        if (!plane.usable) continue;
        auto triangles = start_triangulation(plane.sites(), plane.vertices, start);
        ASSERT_EQ(fault_of(plane.points, triangles), "") << dataset.about.name << " " << n;
        EdgeMesh mesh(triangles);
        flip_at_random(plane.sites(), mesh, 10 * n, 5);
        ASSERT_EQ(fault_of(plane.points, mesh.triangles()), "") << dataset.about.name << " " << n;
        ++meshes;
      }
  EXPECT_GT(meshes, 100);
}

/// Collinear runs at the beginning, at the end, on the hull and on rays of the fan: all subsets of a grid.
TEST(Start, IsATriangulationOfAllSmallLatticeSets) {
  int meshes = 0;
  for (int mask = 1; mask < 512; ++mask)
    for (const Start start : all_starts) {
      const Plane plane(small_lattice_set(mask));
      if (!plane.usable) continue;
      ASSERT_EQ(fault_of(plane.points, start_triangulation(plane.sites(), plane.vertices, start)), "")
          << mask;
      ++meshes;
    }
  EXPECT_EQ(meshes, 3 * (511 - 9 - 36 - 8));  // but for single points, pairs and lines of three
}

TEST(Start, FanJoinsAllSitesToTheLeftmost) {
  Random random(4);
  const Plane plane(integer_points(60, 1000, random));
  const auto leftmost =
      static_cast<Index>(std::min_element(plane.points.begin(), plane.points.end()) - plane.points.begin());
  std::vector<char> joined(plane.points.size(), 0);
  for (const Triangle& t : start_triangulation(plane.sites(), plane.vertices, Start::fan))
    if (std::find(t.begin(), t.end(), leftmost) != t.end())
      for (const Index v : t) joined[v] = 1;
  EXPECT_EQ(std::count(joined.begin(), joined.end(), 1), std::ssize(plane.points));
}

/// Signs drawn by lot, the same ones whenever the same is asked.
class DrawnSigns final : public Kernel2 {
 public:
  explicit DrawnSigns(std::uint64_t seed) : seed_(seed) {}
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override { return drawn({a, b, c}); }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return drawn({a, b, c, d});
  }
  Decision decide_compare_length(Point2, Point2, Point2, Point2) const override { return {}; }
  Decision decide_compare_angle(const Angle<2>&, const Angle<2>&) const override { return {}; }
  bool admits(Point2) const override { return true; }

 private:
  Decision drawn(std::initializer_list<Point2> points) const {
    std::uint64_t asked = seed_;
    for (const Point2& p : points)
      asked = asked * 1000003 + static_cast<std::uint64_t>(p[0]) * 1009 + static_cast<std::uint64_t>(p[1]);
    return {static_cast<Sign>(static_cast<int>(Random(asked).below(3)) - 1), Stage::rounded};
  }
  std::uint64_t seed_;
};

/// Nonsense ends in triangles of some kind or is given up; nothing hangs.
TEST(Start, HalvesEndWhateverTheSigns) {
  int given_up = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const Plane plane(integer_points(40, 30, random));
    try {
      const Halved halved = triangulate_by_halves({plane.points, DrawnSigns(seed)}, plane.vertices);
      EXPECT_LE(halved.triangles.size(), 2 * plane.vertices.size());
    } catch (const Abandon& abandon) {
      EXPECT_EQ(abandon.outcome, Outcome::inconsistent_predicate);
      ++given_up;
    }
  }
  EXPECT_GT(given_up, 0);
}

TEST(Start, HalvesOrderEverySiteOnce) {
  Random random(6);
  const Plane plane(integer_points(300, 1000, random));
  std::vector<Index> order = triangulate_by_halves(plane.sites(), plane.vertices).order;
  std::ranges::sort(order);
  std::vector<Index> vertices = plane.vertices;
  std::ranges::sort(vertices);
  EXPECT_EQ(order, vertices);
}

TEST(Start, RandomFlipsFollowTheirSeedAndLeaveFixedEdges) {
  Random random(5);
  const Plane plane(integer_points(50, 1000, random));
  const auto triangles = start_triangulation(plane.sites(), plane.vertices, Start::sweep);
  EdgeMesh one(triangles), same(triangles), other(triangles), still(triangles);
  EXPECT_GT(flip_at_random(plane.sites(), one, 500, 1), 100U);
  flip_at_random(plane.sites(), same, 500, 1);
  flip_at_random(plane.sites(), other, 500, 2);
  EXPECT_EQ(one.triangles(), same.triangles());
  EXPECT_NE(one.triangles(), other.triangles());
  const std::vector<char> fixed(still.edges(), 1);
  EXPECT_EQ(flip_at_random(plane.sites(), still, 500, 1, fixed), 0U);
}

/// Twins have each other, run the opposite way, and ghosts close the mesh to a sphere.
void is_glued(const PlanarMesh& mesh) {
  for (HalfEdge h = 0; h < 3 * mesh.triangles(); ++h) {
    ASSERT_NE(mesh.twin(h), PlanarMesh::none);
    ASSERT_EQ(mesh.twin(mesh.twin(h)), h);
    ASSERT_EQ(mesh.from(mesh.twin(h)), mesh.to(h));
    ASSERT_EQ(mesh.to(mesh.twin(h)), mesh.from(h));
  }
}

TEST(Assemble, GluesTrianglesAndGhosts) {
  Random random(6);
  const Plane plane(integer_points(80, 20, random));
  const auto triangles = start_triangulation(plane.sites(), plane.vertices, Start::sweep);
  PlanarMesh mesh = assemble(triangles);
  is_glued(mesh);
  for (Index t = 0; t < triangles.size(); ++t) EXPECT_EQ(mesh.triangle(t), triangles[t]);
  for (Index t = static_cast<Index>(triangles.size()); t < mesh.triangles(); ++t)
    EXPECT_TRUE(mesh.is_ghost(t));
  // Splits and flips in place keep it so.
  const auto site = static_cast<Index>(plane.points.size());
  split_triangle(mesh, 0, site);
  is_glued(mesh);
  split_triangle(mesh, static_cast<Index>(triangles.size()), site + 1);  // a ghost
  is_glued(mesh);
  split_edge(mesh, 3, site + 2);
  is_glued(mesh);
  flip_edge(mesh, 7);
  is_glued(mesh);
}

TEST(Assemble, RefusesWhatIsNoTriangulation) {
  const std::vector<Triangle> doubled{{0, 1, 2}, {0, 1, 2}}, folded{{0, 1, 2}, {0, 1, 3}},
      touching{{0, 1, 2}, {0, 3, 4}};
  EXPECT_THROW(assemble(doubled), Abandon);
  EXPECT_THROW(assemble(folded), Abandon);
  EXPECT_THROW(assemble(touching), Abandon);
}

}  // namespace
}  // namespace tribunal::flips
