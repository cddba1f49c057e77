// Insertion with MinMax swaps: what it promises at every step.
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/stretching/min_max_insertion.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/random.hpp"
#include "tests/stretching/support.hpp"

#include <gtest/gtest.h>

namespace tribunal::stretching {
namespace {
using test::polygon;
using test::Sample;

/// Edges inside the domain, not held, whose swap would make the larger angle smaller: counted with the
/// criterion of the flips' room.
std::size_t improving_swaps(const constrained::Mesh& mesh) {
  std::vector<Point2> points;
  for (Index v = 0; v < mesh.vertices(); ++v) points.push_back(mesh.point(v));
  const Sites sites{points, mesh.kernel()};
  const MinMaxCriterion criterion(sites);
  const PlanarMesh& t = mesh.triangles();
  std::size_t count = 0;
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h) {
    if (h > t.twin(h) || mesh.held(h) || !mesh.inside(triangle_of(h))) continue;
    const Quadrilateral q{t.from(h), t.to(h), t.corner(h), t.corner(t.twin(h))};
    count += is_strictly_convex(sites, q) && criterion.improves(q);
  }
  return count;
}

TEST(LargestCorner, IsThatOfTheFlipsRoom) {
  const auto points = find_dataset("uniform")->generate(300, 1);
  const auto kernel = std::move(std::get<0>(find_backend("gmp")->bind2(points)));
  const Sites sites{points, *kernel};
  for (Index i = 0; i + 2 < points.size(); ++i) {
    const Triangle corner = tribunal::largest_corner(sites, {i, i + 1, i + 2});
    const Angle<2> found = stretching::largest_corner(*kernel, points[i], points[i + 1], points[i + 2]);
    EXPECT_EQ(found[1], points[corner[1]]);
  }
}

class Insertions : public ::testing::TestWithParam<const char*> {};

/// Points on a lattice, so that many fall on edges and many angles are equal.
TEST_P(Insertions, LeaveALocallyMinMaxTriangulation) {
  DatasetGraph square =
      polygon({{{0, 0}}, {{64, 0}}, {{64, 64}}, {{40, 64}}, {{40, 20}}, {{24, 20}}, {{24, 64}}, {{0, 64}}});
  const Sample sample(square);
  auto built = sample.mesh();
  constrained::Mesh& mesh = built.mesh;
  MinMaxInsertion insertion(mesh);
  EXPECT_EQ(improving_swaps(mesh), 0U);
  Random random(7);
  const double lattice = GetParam() == std::string_view("lattice") ? 1 : 0x1p-30;
  std::size_t on_edges = 0;
  for (int i = 0; i < 600; ++i) {
    const auto coordinate = [&] {
      return lattice * static_cast<double>(random.below(static_cast<std::uint64_t>(64 / lattice)));
    };
    const Point2 p{{coordinate(), coordinate()}};
    Index start = static_cast<Index>(random.below(mesh.triangles().triangles()));
    if (!mesh.inside(start)) continue;
    std::uint64_t steps = 0;
    const auto seen = refinement::look(mesh, start, p, steps);
    const bool on_edge = seen.kind == refinement::Sighting::Kind::on_edge && !mesh.held(seen.at);
    if (seen.kind != refinement::Sighting::Kind::inside && !on_edge) continue;
    on_edges += on_edge;
    const Angle<2> promised = insertion.largest_around(p, seen);
    EXPECT_TRUE(promised[0] == p || promised[1] == p || promised[2] == p);
    const Index vertex = insertion.insert(p, seen);
    EXPECT_EQ(mesh.point(vertex), p);
    ASSERT_EQ(improving_swaps(mesh), 0U) << i;
  }
  EXPECT_GT(mesh.vertices(), 40U);
  EXPECT_TRUE(lattice < 1 || on_edges > 3);
  insertion.swap_anew();
  EXPECT_EQ(improving_swaps(mesh), 0U);

  std::vector<Triangle> triangles;
  std::vector<Point2> points;
  for (Index v = 0; v < mesh.vertices(); ++v) points.push_back(mesh.point(v));
  for (Index t = 0; t < mesh.triangles().triangles(); ++t)
    if (mesh.inside(t)) triangles.push_back(mesh.triangles().triangle(t));
  std::vector<Edge> segments;
  for (const auto& [a, b] : square.segments) segments.push_back({built.vertex[a], built.vertex[b]});
  const auto verdict = verify::verify_constrained(points, {triangles}, {segments, {}, verify::Domain::carved},
                                                  {.kind = verify::Kind::triangulation});
  EXPECT_TRUE(verdict.valid()) << verdict.faults[0].detail;
}
INSTANTIATE_TEST_SUITE_P(Places, Insertions, ::testing::Values("lattice", "anywhere"));

}  // namespace
}  // namespace tribunal::stretching
