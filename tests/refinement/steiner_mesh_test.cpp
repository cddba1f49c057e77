// Steiner points in and out at random: after every operation the exact checker judges the whole mesh.
#include "algorithms/refinement/steiner_mesh.hpp"

#include "algorithms/mesh/canonical.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"
#include "tests/constrained/lattice_graph.hpp"
#include "tests/refinement/judged.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

namespace tribunal::refinement {
namespace {

/// A graph turned off its lattice, so that midpoints of its segments are no doubles.
LatticeGraph turned(LatticeGraph graph) {
  const auto turn = [](Point2& p) { p = {{0.6 * p[0] - 0.8 * p[1] + 0.1, 0.8 * p[0] + 0.6 * p[1]}}; };
  for (Point2& p : graph.points) turn(p);
  for (Point2& p : graph.holes) turn(p);
  return graph;
}

/// The mesh of a random graph with its kernel; null where the graph is refused.
struct Subject {
  LatticeGraph graph;
  Kernel2Binding bound;
  std::unique_ptr<SteinerMesh> mesh;

  Subject(LatticeGraph of, Domain domain)
      : graph(std::move(of)), bound(find_backend("filtered")->bind2(graph.points)) {
    try {
      const auto order = insertion_order(graph.points, Order::random, 1);
      mesh = std::make_unique<SteinerMesh>(graph.as(domain), order, *std::get<0>(bound));
    } catch (const Abandon& abandon) {
      EXPECT_EQ(abandon.outcome, Outcome::refused_input) << abandon.what();
    }
  }
};

/// The checker's word. A hull is bounded by held edges, too.
std::string faults_of(const Refined& refined, const LatticeGraph& graph, Domain domain) {
  const auto meant = domain == Domain::even_odd ? verify::Domain::even_odd : verify::Domain::carved;
  return faults_of(refined, domain == Domain::hull ? std::vector<Point2>{} : graph.holes, meant);
}

Index random_triangle(const SteinerMesh& mesh, Random& random) {
  for (;;) {
    const auto t = static_cast<Index>(random.below(mesh.triangles().triangles()));
    if (mesh.in_domain(t)) return t;
  }
}

/// A point inside a triangle, on its boundary or a little beyond it.
Point2 random_target(const SteinerMesh& mesh, Random& random) {
  const auto [a, b, c] = mesh.corners(random_triangle(mesh, random));
  const double u = static_cast<double>(random.below(9)) / 4 - 0.5,
               v = static_cast<double>(random.below(9)) / 4 - 0.5;
  return {{a[0] + u * (b[0] - a[0]) + v * (c[0] - a[0]), a[1] + u * (b[1] - a[1]) + v * (c[1] - a[1])}};
}

/// One operation that the mesh allows; false where it came to nothing.
bool operate(SteinerMesh& mesh, Random& random) {
  if (random.below(4) == 0) {
    const auto v = static_cast<Index>(random.below(mesh.mesh().vertices()));
    if (mesh.role(v) != Role::free) return false;
    for (const Index t : mesh.remove(v)) EXPECT_TRUE(mesh.in_domain(t));
    return true;
  }
  const Point2 p = random_target(mesh, random);
  if (!mesh.mesh().kernel().admits(p)) return false;
  const Sighting seen = mesh.look(random_triangle(mesh, random), p);
  if (seen.kind == Sighting::Kind::at_vertex) return false;
  const bool held = seen.kind == Sighting::Kind::blocked ||
                    (seen.kind == Sighting::Kind::on_edge && mesh.mesh().held(seen.at));
  if (held) return mesh.split(seen.at).has_value();
  mesh.insert(p, seen);
  return true;
}

constexpr std::array domains{Domain::hull, Domain::carved, Domain::even_odd};

TEST(SteinerMesh, EveryOperationLeavesAConstrainedDelaunayMesh) {
  Random random(11);
  int graphs = 0, done = 0;
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    const Domain domain = domains[i % 3];
    const LatticeGraph drawn = random_graph(random);
    Subject subject(i % 2 == 0 ? drawn : turned(drawn), domain);
    if (!subject.mesh) continue;
    ++graphs;
    SCOPED_TRACE("case " + std::to_string(i) + "\n" + describe(subject.graph));
    for (int step = 0; step < 30 && !HasFailure(); ++step) {
      if (!operate(*subject.mesh, random)) continue;
      ++done;
      if (step % 5 != 0) continue;
      const Refined refined = subject.mesh->result();
      EXPECT_EQ(faults_of(refined, subject.graph, domain), "");
    }
    expect_paths(subject.mesh->result(), subject.graph.points, subject.graph.segments);
  }
  EXPECT_GT(graphs, 300);
  EXPECT_GT(done, 5000);
}

/// By brute force: the triangle is the one asked about.
bool holds(const SteinerMesh& mesh, Index t, Point2 p, bool inside) {
  const auto [a, b, c] = mesh.corners(t);
  const Kernel2& kernel = mesh.mesh().kernel();
  for (const Sign side : {kernel.orient2d(a, b, p), kernel.orient2d(b, c, p), kernel.orient2d(c, a, p)})
    if (side == Sign::negative || (inside && side == Sign::zero)) return false;
  return true;
}

// What is seen holds the point; what blocks has it strictly behind it. A point in the triangle itself is
// always seen, and in a convex domain without segments inside every point of it.
TEST(SteinerMesh, LooksEndWhereThePointIs) {
  Random random(12);
  int seen = 0, blocked = 0, at_vertex = 0, on_edge = 0;
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    LatticeGraph graph = random_graph(random);
    const bool convex = i % 3 == 0;
    if (convex) graph.segments.clear();
    Subject subject(std::move(graph), Domain::hull);
    if (!subject.mesh) continue;
    SteinerMesh& mesh = *subject.mesh;
    SCOPED_TRACE("case " + std::to_string(i) + "\n" + describe(subject.graph));
    for (int step = 0; step < 30; ++step) {
      operate(mesh, random);
      const Point2 p = random_target(mesh, random);
      if (!mesh.mesh().kernel().admits(p)) continue;
      const Index from = random_triangle(mesh, random);
      const Sighting found = mesh.look(from, p);
      const HalfEdge h = found.at;
      const PlanarMesh& t = mesh.triangles();
      const Sign side = mesh.mesh().kernel().orient2d(mesh.point(t.from(h)), mesh.point(t.to(h)), p);
      EXPECT_TRUE(mesh.in_domain(triangle_of(h)));
      switch (found.kind) {
        case Sighting::Kind::inside:
          EXPECT_TRUE(holds(mesh, triangle_of(h), p, true));
          break;
        case Sighting::Kind::on_edge:
          EXPECT_TRUE(side == Sign::zero && strictly_between(mesh.point(t.from(h)), p, mesh.point(t.to(h))));
          ++on_edge;
          break;
        case Sighting::Kind::at_vertex:
          EXPECT_TRUE(mesh.point(t.corner(h)) == p);
          ++at_vertex;
          break;
        case Sighting::Kind::blocked:
          EXPECT_TRUE(mesh.mesh().held(h) && side == Sign::negative);
          EXPECT_FALSE(holds(mesh, from, p, false));
          EXPECT_FALSE(convex && mesh.in_domain(triangle_of(t.twin(h))));
          ++blocked;
      }
      seen += found.kind != Sighting::Kind::blocked;
    }
  }
  EXPECT_GT(seen, 10000);
  EXPECT_GT(blocked, 1000);
  EXPECT_GT(on_edge, 100);
  EXPECT_GT(at_vertex, 100);
}

// A vertex that comes and goes leaves nothing behind: without ties the mesh is the one before.
TEST(SteinerMesh, RemovalUndoesInsertion) {
  Random random(13);
  int compared = 0;
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    LatticeGraph graph = random_graph(random);
    for (Point2& p : graph.points) p = {{p[0] + random.unit() / 64, p[1] + random.unit() / 64}};
    Subject subject(std::move(graph), Domain::hull);
    if (!subject.mesh) continue;
    SteinerMesh& mesh = *subject.mesh;
    for (int step = 0; step < 10; ++step) {
      const auto before = digest(mesh.result().triangles);
      const Point2 p = random_target(mesh, random);
      if (!mesh.mesh().kernel().admits(p)) continue;
      const Sighting found = mesh.look(random_triangle(mesh, random), p);
      if (found.kind != Sighting::Kind::inside) continue;
      const std::size_t vertices = mesh.vertices();
      mesh.remove(mesh.insert(p, found));
      EXPECT_EQ(mesh.vertices(), vertices);
      EXPECT_EQ(digest(mesh.result().triangles), before);
      ++compared;
      operate(mesh, random);
    }
  }
  EXPECT_GT(compared, 800);
}

// The same operations, the same mesh, whoever decides the signs.
TEST(SteinerMesh, ExactBackendsAgree) {
  Random random(14);
  for (int i = 0; i < 40 && !HasFailure(); ++i) {
    const LatticeGraph graph = turned(random_graph(random));
    const auto order = insertion_order(graph.points, Order::random, 1);
    std::map<std::uint64_t, std::string_view> digests;
    for (const std::string_view name : {"filtered", "gmp", "adaptive", "interval"}) {
      const Kernel2Binding bound = find_backend(name)->bind2(graph.points);
      try {
        SteinerMesh mesh(graph.as(Domain::hull), order, *std::get<0>(bound));
        Random same(static_cast<std::uint64_t>(i));
        for (int step = 0; step < 20; ++step) {
          const Sighting found =
              mesh.look(random_triangle(mesh, same), graph.points[same.below(graph.points.size())]);
          if (found.kind == Sighting::Kind::blocked) mesh.split(found.at);
        }
        digests.emplace(digest(mesh.result().triangles), name);
      } catch (const Abandon& abandon) {
        EXPECT_EQ(abandon.outcome, Outcome::refused_input) << abandon.what();
      }
    }
    EXPECT_LE(digests.size(), 1U);
  }
}

}  // namespace
}  // namespace tribunal::refinement
