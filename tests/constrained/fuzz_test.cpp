// Random graphs of every degenerate kind, each backend, both recoveries; the exact checker judges.
#include "algorithms/mesh/canonical.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"
#include "tests/constrained/lattice_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace tribunal {
namespace {

std::vector<Index> shuffled(const LatticeGraph& graph, std::uint64_t seed) {
  return insertion_order(graph.points, Order::random, seed);
}

ConstrainedTriangulation run(const LatticeGraph& graph, Domain domain, Recovery recovery,
                             std::string_view backend = "filtered", std::uint64_t seed = 1) {
  const Kernel2Binding bound = find_backend(backend)->bind2(graph.points);
  return triangulate_graph(graph.as(domain), shuffled(graph, seed), *std::get<0>(bound), recovery);
}

verify::Verdict judge(const LatticeGraph& graph, Domain domain, const ConstrainedTriangulation& t) {
  return verify::verify_constrained(graph.points, {t.mesh.triangles}, graph.constraints(domain));
}

std::string faults_of(const verify::Verdict& verdict) {
  std::string text;
  for (const auto& fault : verdict.faults)
    text.append(verify::to_string(fault.kind)).append(": ").append(fault.detail).append("\n");
  return text;
}

/// Over all tests of this file 19,000 graphs, in the long tiers 119,000.
const int cases = std::getenv("TRIBUNAL_LONG_TIERS") == nullptr ? 4000 : 25'000;

// Refused exactly where two segments cross away from all vertices, and two such segments are named; else the
// mesh is the constrained Delaunay triangulation.
TEST(Fuzz, RefusesWhatCrossesAndTriangulatesTheRest) {
  Random random(1);
  int refused = 0, flat = 0;
  for (int i = 0; i < cases && !HasFailure(); ++i) {
    const LatticeGraph graph = random_graph(random);
    SCOPED_TRACE("case " + std::to_string(i) + "\n" + describe(graph));
    for (const Recovery recovery : {Recovery::swaps, Recovery::cavity}) {
      const auto t = run(graph, Domain::hull, recovery);
      flat += t.mesh.dimension < 2;
      if (t.crossing) {
        ++refused;
        EXPECT_EQ(t.mesh.outcome, Outcome::refused_input);
        EXPECT_TRUE(cross(graph, graph.segments[(*t.crossing)[0]], graph.segments[(*t.crossing)[1]]));
        continue;
      }
      EXPECT_EQ(t.mesh.outcome, Outcome::ok) << t.mesh.reason;
      EXPECT_TRUE(t.mesh.dimension < 2 || !any_crossing(graph));
      const auto verdict = judge(graph, Domain::hull, t);
      EXPECT_TRUE(verdict.valid()) << faults_of(verdict);
    }
  }
  EXPECT_GT(refused, cases / 20);
  EXPECT_LT(refused, cases);
  EXPECT_LT(flat, cases / 2);
}

// The touches are all pairs of a segment and a distinct site strictly inside it.
TEST(Fuzz, NamesTheVerticesOnSegments) {
  Random random(2);
  for (int i = 0; i < cases / 4 && !HasFailure(); ++i) {
    const LatticeGraph graph = random_graph(random);
    const auto t = run(graph, Domain::hull, Recovery::cavity);
    if (t.mesh.outcome != Outcome::ok || t.mesh.dimension < 2) continue;
    SCOPED_TRACE(describe(graph));
    std::set<std::pair<Index, Point2>> expected, found;
    for (Index s = 0; s < graph.segments.size(); ++s)
      for (const Point2& site : graph.points)
        if (inside_segment(graph, graph.segments[s], site)) expected.insert({s, site});
    for (const Touch& touch : t.touches) found.insert({touch.segment, graph.points[touch.vertex]});
    EXPECT_EQ(found, expected);
  }
}

// Without ties there is one constrained Delaunay triangulation: neither the way segments are recovered, nor
// the order of insertion, nor the backend matters.
TEST(Fuzz, OneMeshHoweverItIsMade) {
  Random random(3);
  int compared = 0;
  for (int i = 0; i < 20 * cases && compared < cases / 8 && !HasFailure(); ++i) {
    const LatticeGraph graph = random_graph(random);
    const auto first = run(graph, Domain::hull, Recovery::cavity);
    if (first.mesh.outcome != Outcome::ok || first.mesh.dimension < 2) continue;
    const bool unique = judge(graph, Domain::hull, first).ties == 0;
    compared += unique;
    SCOPED_TRACE(describe(graph));
    for (const BackendEntry& backend : backends()) {
      if (!backend.about->exact) continue;
      const auto same = run(graph, Domain::hull, Recovery::cavity, backend.about->name);
      EXPECT_EQ(digest(same.mesh.triangles), digest(first.mesh.triangles)) << backend.about->name;
    }
    if (!unique) continue;
    const auto swapped = run(graph, Domain::hull, Recovery::swaps, "filtered", 7);
    EXPECT_EQ(digest(swapped.mesh.triangles), digest(first.mesh.triangles));
  }
  EXPECT_EQ(compared, cases / 8);
}

/// Whether some site is the end of an odd number of segments: a loop is open there.
bool has_open_end(const LatticeGraph& graph) {
  std::multiset<Point2> ends;
  for (const auto& [a, b] : graph.segments)
    if (!(graph.points[a] == graph.points[b])) {
      ends.insert(graph.points[a]);
      ends.insert(graph.points[b]);
    }
  return std::any_of(ends.begin(), ends.end(), [&](Point2 end) { return ends.count(end) % 2 == 1; });
}

TEST(Fuzz, DomainsByTheEvenOddRule) {
  Random random(4);
  int meshed = 0, open = 0;
  for (int i = 0; i < cases && !HasFailure(); ++i) {
    const LatticeGraph graph = random_graph(random);
    SCOPED_TRACE(describe(graph));
    const auto t = run(graph, Domain::even_odd, i % 2 == 0 ? Recovery::cavity : Recovery::swaps);
    if (t.crossing || t.mesh.dimension < 2) continue;
    EXPECT_EQ(t.open_end.has_value(), has_open_end(graph));
    open += t.open_end.has_value();
    if (t.mesh.outcome != Outcome::ok) {
      EXPECT_EQ(t.mesh.outcome, Outcome::refused_input);
      continue;
    }
    ++meshed;
    const auto verdict = judge(graph, Domain::even_odd, t);
    EXPECT_TRUE(verdict.valid()) << faults_of(verdict);
  }
  EXPECT_GT(meshed, cases / 40);
  EXPECT_GT(open, cases / 10);
}

TEST(Fuzz, DomainsCarvedByHoles) {
  Random random(5);
  int meshed = 0, no_hole = 0;
  for (int i = 0; i < 2 * cases && !HasFailure(); ++i) {
    const LatticeGraph graph = random_graph(random);
    SCOPED_TRACE(describe(graph));
    const auto t = run(graph, Domain::carved, i % 2 == 0 ? Recovery::cavity : Recovery::swaps);
    no_hole += t.hole.has_value();
    if (t.mesh.outcome != Outcome::ok) {
      EXPECT_EQ(t.mesh.outcome, Outcome::refused_input) << t.mesh.reason;
      continue;
    }
    ++meshed;
    const auto verdict = judge(graph, Domain::carved, t);
    EXPECT_TRUE(verdict.valid()) << faults_of(verdict);
  }
  EXPECT_GT(meshed, cases / 10);
  EXPECT_GT(no_hole, cases / 20);
}

// A backend that is not exact may fail, but it must end and say how.
TEST(Fuzz, WrongSignsEnd) {
  Random random(6);
  for (int i = 0; i < cases / 8; ++i) {
    LatticeGraph graph = random_graph(random);
    for (Point2& p : graph.points) p = {{p[0] * 0.1 + 1e6, p[1] * 0.1 - p[0] * 1e-11}};
    for (const BackendEntry& backend : backends()) {
      const Kernel2Binding bound = backend.bind2(graph.points);
      if (std::holds_alternative<Refusal>(bound)) continue;
      for (const Recovery recovery : {Recovery::swaps, Recovery::cavity}) {
        const auto t =
            triangulate_graph(graph.as(Domain::hull), shuffled(graph, 1), *std::get<0>(bound), recovery);
        if (backend.about->exact) {
          EXPECT_TRUE(t.mesh.outcome == Outcome::ok || t.crossing.has_value()) << t.mesh.reason;
        }
        EXPECT_TRUE(t.mesh.outcome == Outcome::ok || !t.mesh.reason.empty());
      }
    }
  }
}

}  // namespace
}  // namespace tribunal
