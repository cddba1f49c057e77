// Who checks the checker: faults planted into valid constrained meshes are found and named.
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"
#include "tests/constrained/lattice_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace tribunal {
namespace {

using verify::FaultKind;
using Triangles = std::vector<Triangle>;

struct Sample {
  LatticeGraph graph;
  Domain domain;
  ConstrainedTriangulation found;
};

/// A random graph that has a mesh with triangles.
Sample draw_sample(Random& random, Domain domain) {
  for (;;) {
    Sample sample{random_graph(random), domain, {}};
    const Kernel2Binding bound = find_backend("gmp")->bind2(sample.graph.points);
    sample.found = triangulate_graph(
        sample.graph.as(domain), insertion_order(sample.graph.points, Order::random, 1), *std::get<0>(bound));
    if (sample.found.mesh.outcome == Outcome::ok && !sample.found.mesh.triangles.empty()) return sample;
  }
}

verify::Verdict judge(const Sample& sample, const Triangles& triangles) {
  return verify::verify_constrained(sample.graph.points, {triangles},
                                    sample.graph.constraints(sample.domain));
}

bool names(const verify::Verdict& verdict, FaultKind kind) {
  return std::any_of(verdict.faults.begin(), verdict.faults.end(),
                     [&](const verify::Fault& fault) { return fault.kind == kind; });
}

using Key = std::pair<Index, Index>;
Key key(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// Of each edge the triangles that have it.
std::map<Key, std::vector<std::size_t>> edges_of(const Triangles& triangles) {
  std::map<Key, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) edges[key(triangles[t][i], triangles[t][(i + 1) % 3])].push_back(t);
  return edges;
}
std::set<Key> held_edges(const Sample& sample) {
  std::set<Key> held;
  for (const auto& [a, b] : sample.found.constraints) held.insert(key(a, b));
  return held;
}

Index apex(const Triangle& t, const Key& edge) {
  return *std::find_if(t.begin(), t.end(), [&](Index v) { return v != edge.first && v != edge.second; });
}

/// The mesh with one edge, held or not, swapped for the other diagonal of a strictly convex quadrilateral.
std::optional<Triangles> with_swap(const Sample& sample, bool held) {
  const auto& points = sample.graph.points;
  const std::set<Key> holds = held_edges(sample);
  for (const auto& [edge, around] : edges_of(sample.found.mesh.triangles)) {
    if (around.size() != 2 || holds.contains(edge) != held) continue;
    Triangles mesh = sample.found.mesh.triangles;
    Index a = edge.first, b = edge.second;
    const Index p = apex(mesh[around[0]], edge), q = apex(mesh[around[1]], edge);
    if (area(points[a], points[b], points[p]) < 0) std::swap(a, b);
    if (area(points[q], points[b], points[p]) <= 0 || area(points[q], points[p], points[a]) <= 0) continue;
    mesh[around[0]] = {q, b, p};
    mesh[around[1]] = {q, p, a};
    return mesh;
  }
  return std::nullopt;
}

constexpr int wanted = 100;

TEST(Checker, NamesASegmentSwappedAway) {
  Random random(11);
  for (int planted = 0; planted < wanted && !HasFailure();) {
    const Sample sample = draw_sample(random, Domain::hull);
    const auto mesh = with_swap(sample, true);
    if (!mesh) continue;
    ++planted;
    EXPECT_TRUE(names(judge(sample, *mesh), FaultKind::missing_segment)) << describe(sample.graph);
  }
}

// A diagonal of four cocircular points may be either one.
TEST(Checker, NamesACircleWithAVertexInside) {
  Random random(12);
  for (int planted = 0; planted < wanted && !HasFailure();) {
    const Sample sample = draw_sample(random, Domain::hull);
    const auto mesh = with_swap(sample, false);
    if (!mesh || judge(sample, sample.found.mesh.triangles).ties > 0) continue;
    ++planted;
    EXPECT_TRUE(names(judge(sample, *mesh), FaultKind::non_delaunay)) << describe(sample.graph);
  }
}

TEST(Checker, NamesALostTriangle) {
  Random random(13);
  for (const Domain domain : {Domain::hull, Domain::carved, Domain::even_odd})
    for (int planted = 0; planted < wanted && !HasFailure(); ++planted) {
      const Sample sample = draw_sample(random, domain);
      Triangles mesh = sample.found.mesh.triangles;
      mesh.erase(mesh.begin() + static_cast<std::ptrdiff_t>(random.below(mesh.size())));
      EXPECT_FALSE(judge(sample, mesh).valid()) << static_cast<int>(domain) << describe(sample.graph);
    }
}

TEST(Checker, NamesAHoleThatIsFilled) {
  Random random(14);
  for (const Domain domain : {Domain::carved, Domain::even_odd})
    for (int planted = 0; planted < wanted && !HasFailure();) {
      const Sample sample = draw_sample(random, domain);
      Sample whole = sample;
      whole.domain = Domain::hull;
      const Kernel2Binding bound = find_backend("gmp")->bind2(sample.graph.points);
      const auto full =
          triangulate_graph(sample.graph.as(Domain::hull),
                            insertion_order(sample.graph.points, Order::random, 1), *std::get<0>(bound));
      if (full.mesh.triangles.size() == sample.found.mesh.triangles.size()) continue;
      ++planted;
      EXPECT_TRUE(judge(whole, full.mesh.triangles).valid());
      EXPECT_TRUE(names(judge(sample, full.mesh.triangles), FaultKind::wrong_domain))
          << describe(sample.graph);
    }
}

/// The triangles of one region: connected across free edges.
std::set<std::size_t> region_of(const Sample& sample, std::size_t start) {
  const Triangles& mesh = sample.found.mesh.triangles;
  const auto edges = edges_of(mesh);
  const std::set<Key> held = held_edges(sample);
  std::set<std::size_t> region{start};
  std::vector<std::size_t> front{start};
  while (!front.empty()) {
    const std::size_t t = front.back();
    front.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Key edge = key(mesh[t][i], mesh[t][(i + 1) % 3]);
      if (held.contains(edge)) continue;
      for (const std::size_t next : edges.at(edge))
        if (region.insert(next).second) front.push_back(next);
    }
  }
  return region;
}

// A whole region left out leaves nothing inconsistent behind; only the domain is wrong.
TEST(Checker, NamesARegionLeftOut) {
  Random random(15);
  for (const Domain domain : {Domain::carved, Domain::even_odd})
    for (int planted = 0; planted < wanted && !HasFailure(); ++planted) {
      const Sample sample = draw_sample(random, domain);
      const Triangles& all = sample.found.mesh.triangles;
      const auto region = region_of(sample, random.below(all.size()));
      Triangles mesh;
      for (std::size_t t = 0; t < all.size(); ++t)
        if (!region.contains(t)) mesh.push_back(all[t]);
      EXPECT_TRUE(names(judge(sample, mesh), FaultKind::wrong_domain))
          << static_cast<int>(domain) << describe(sample.graph);
    }
}

TEST(Checker, NamesASiteInsideATriangle) {
  Random random(16);
  for (const Domain domain : {Domain::carved, Domain::even_odd})
    for (int planted = 0; planted < wanted && !HasFailure(); ++planted) {
      Sample sample = draw_sample(random, domain);
      const auto& points = sample.graph.points;
      const Triangle t = sample.found.mesh.triangles[random.below(sample.found.mesh.triangles.size())];
      const auto mean = [&](std::size_t axis) {
        return (2 * points[t[0]][axis] + points[t[1]][axis] + points[t[2]][axis]) / 4;
      };
      sample.graph.points.push_back({{mean(0), mean(1)}});
      EXPECT_TRUE(names(judge(sample, sample.found.mesh.triangles), FaultKind::crossing_edges))
          << describe(sample.graph);
    }
}

TEST(Checker, RefusesSegmentsWithoutPointsAndHolesThatAreNone) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}};
  const Triangles mesh{{0, 1, 2}};
  const std::vector<Edge> beyond{{0, 3}};
  EXPECT_THROW((void)verify::verify_constrained(points, {mesh}, {beyond}), std::invalid_argument);
  const std::vector<Point2> nowhere{{{0, std::numeric_limits<double>::quiet_NaN()}}};
  EXPECT_THROW((void)verify::verify_constrained(points, {mesh}, {{}, nowhere}), std::invalid_argument);
}

// Segments that run over nothing of the mesh, and holes everywhere: whatever they say, the checker ends.
TEST(Checker, EndsOnNonsense) {
  Random random(17);
  for (int i = 0; i < 2000; ++i) {
    const LatticeGraph graph = random_graph(random);
    Triangles mesh;
    for (auto triangles = random.below(8); triangles > 0; --triangles)
      mesh.push_back({static_cast<Index>(random.below(graph.points.size() + 1)),
                      static_cast<Index>(random.below(graph.points.size())),
                      static_cast<Index>(random.below(graph.points.size()))});
    for (const Domain domain : {Domain::hull, Domain::carved, Domain::even_odd})
      (void)verify::verify_constrained(graph.points, {mesh}, graph.constraints(domain));
  }
}

}  // namespace
}  // namespace tribunal
