// Law: what is done edge by edge to a mesh leaves it consistent.
#include "algorithms/greedy/constrained_mesh.hpp"
#include "algorithms/greedy/locked_spokes.hpp"
#include "tests/greedy/support.hpp"

namespace tribunal::greedy {
namespace {

/// The ring of locked half-edges around a vertex, by looking at all half-edges around it.
std::vector<HalfEdge> ring_by_rotation(const EdgeMesh& mesh, const std::vector<char>& locked,
                                       HalfEdge start) {
  std::vector<HalfEdge> ring;
  HalfEdge h = start;
  do {
    if (locked[EdgeMesh::edge_of(h)]) ring.push_back(h);
    h = mesh.next_counter_clockwise(h);
  } while (h != start);
  return ring;
}

TEST(LockedSpokes, FollowOneAnotherCounterClockwise) {
  Random random(4);
  const Plane plane(points_of(random_sites(random, 80, 1000)));
  const EdgeMesh mesh(find_planar_algorithm("bowyer")->run(plane.problem()).triangles);
  LockedSpokes spokes(mesh);
  std::vector<char> locked(mesh.edges(), 0);
  std::vector<Index> order(mesh.edges());
  std::iota(order.begin(), order.end(), Index{0});
  random.shuffle(std::span(order));
  for (const Index edge : order) {
    locked[edge] = 1;
    for (const HalfEdge h : {2 * edge, 2 * edge + 1}) {
      spokes.insert(h);
      const auto ring = ring_by_rotation(mesh, locked, h);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_EQ(spokes.following(ring[i]), ring[(i + 1) % ring.size()]);
        EXPECT_EQ(spokes.preceding(ring[(i + 1) % ring.size()]), ring[i]);
      }
    }
    if (edge % 3 == 0 && testing::Test::HasFailure()) return;
  }
}

/// A forced edge is there, and every other one is locally Delaunay.
TEST(ConstrainedMesh, ForcedEdgesLeaveTheRestDelaunay) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const LatticeSites sites = random_sites(random, 40, seed % 2 == 0 ? 12 : 2000);
    const Plane plane(points_of(sites));
    std::vector<Edge> given;
    for (int tries = 0; tries < 60; ++tries) {
      const Edge edge{static_cast<Index>(random.below(40)), static_cast<Index>(random.below(40))};
      if (edge[0] == edge[1] || meets_a_site(sites, edge)) continue;
      if (std::none_of(given.begin(), given.end(), [&](const Edge& e) {
            return conflict(sites, e, edge) || e == edge || e == Edge{edge[1], edge[0]};
          }))
        given.push_back(edge);
    }
    ConstrainedMesh constrained(plane.problem(),
                                find_planar_algorithm("bowyer")->run(plane.problem()).triangles);
    const std::vector<Index> forced = constrained.force(given);
    ASSERT_EQ(forced.size(), given.size());
    const EdgeMesh& mesh = constrained.mesh();
    for (std::size_t i = 0; i < given.size(); ++i)
      EXPECT_EQ(undirected(mesh.from(2 * forced[i]), mesh.to(2 * forced[i])),
                undirected(given[i][0], given[i][1]));
    std::int64_t doubled_area = 0;
    for (const Triangle& t : mesh.triangles()) {
      EXPECT_GT(area(sites[t[0]], sites[t[1]], sites[t[2]]), 0);
      doubled_area += area(sites[t[0]], sites[t[1]], sites[t[2]]);
    }
    const EdgeMesh before(find_planar_algorithm("bowyer")->run(plane.problem()).triangles);
    for (const Triangle& t : before.triangles()) doubled_area -= area(sites[t[0]], sites[t[1]], sites[t[2]]);
    EXPECT_EQ(doubled_area, 0);
    for (Index edge = 0; edge < mesh.edges(); ++edge) {
      if (!mesh.is_inner(edge) || constrained.is_locked(edge)) continue;
      const auto& p = plane.problem().points;
      const HalfEdge h = 2 * edge;
      EXPECT_NE(plane.problem().kernel.incircle(p[mesh.from(h)], p[mesh.to(h)], p[mesh.apex(h)],
                                                p[mesh.apex(EdgeMesh::twin(h))]),
                Sign::positive)
          << seed;
    }
  }
}

TEST(EdgeMesh, TrianglesThatDoNotFitAreRefused) {
  const std::vector<Triangle> fan{{0, 1, 2}, {0, 1, 3}}, twice{{0, 1, 2}, {0, 1, 2}},
      touching{{0, 1, 2}, {0, 3, 4}};
  for (const auto& triangles : {fan, twice, touching}) EXPECT_THROW(EdgeMesh{triangles}, Abandon);
}

}  // namespace
}  // namespace tribunal::greedy
