// Graphs whose triangulations are known, and large real ones.
#include "datasets/dataset.hpp"
#include "datasets/real.hpp"
#include "predicates/backends/list.hpp"
#include "tests/constrained/lattice_graph.hpp"

#include <gtest/gtest.h>

namespace tribunal {
namespace {

ConstrainedTriangulation run(const LatticeGraph& graph, Domain domain, Recovery recovery = Recovery::cavity,
                             Order order = Order::input) {
  const Kernel2Binding bound = find_backend("filtered")->bind2(graph.points);
  return triangulate_graph(graph.as(domain), insertion_order(graph.points, order, 1), *std::get<0>(bound),
                           recovery);
}

void expect_valid(const LatticeGraph& graph, Domain domain, const ConstrainedTriangulation& t) {
  ASSERT_EQ(t.mesh.outcome, Outcome::ok) << t.mesh.reason;
  const auto verdict =
      verify::verify_constrained(graph.points, {t.mesh.triangles}, graph.constraints(domain));
  EXPECT_TRUE(verdict.valid()) << (verdict.valid() ? "" : verdict.faults[0].detail);
}

/// A square of side 8 with a square hole of side 2 in its middle.
LatticeGraph square_with_hole() {
  return {{{{0, 0}}, {{8, 0}}, {{8, 8}}, {{0, 8}}, {{3, 3}}, {{5, 3}}, {{5, 5}}, {{3, 5}}},
          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}},
          {{{4, 4.5}}}};
}

TEST(Known, SquareWithAHole) {
  const LatticeGraph graph = square_with_hole();
  EXPECT_EQ(run(graph, Domain::hull).mesh.triangles.size(), 10U);
  for (const Domain domain : {Domain::carved, Domain::even_odd}) {
    const auto t = run(graph, domain);
    EXPECT_EQ(t.mesh.triangles.size(), 8U);
    EXPECT_EQ(t.constraints.size(), 8U);
    expect_valid(graph, domain, t);
  }
}

TEST(Known, HolesThatAreNone) {
  LatticeGraph graph = square_with_hole();
  for (const Point2 hole : {Point2{{9, 9}}, Point2{{-1, 4}}, Point2{{8, 4}}, Point2{{3, 4}}}) {
    graph.holes = {{{4, 4}}, hole};
    const auto t = run(graph, Domain::carved);
    EXPECT_EQ(t.mesh.outcome, Outcome::refused_input);
    EXPECT_EQ(t.hole, 1U) << t.mesh.reason;
  }
}

TEST(Known, OpenLoops) {
  LatticeGraph graph = square_with_hole();
  graph.segments.erase(graph.segments.begin() + 3);
  const auto by_parity = run(graph, Domain::even_odd);
  EXPECT_EQ(by_parity.mesh.outcome, Outcome::refused_input);
  EXPECT_TRUE(by_parity.open_end == 0U || by_parity.open_end == 3U);
  graph.segments.erase(graph.segments.begin(), graph.segments.begin() + 4);
  EXPECT_EQ(run(graph, Domain::carved).mesh.outcome, Outcome::refused_input);
}

// A segment across a strip of needles crosses all of them; one along it through its vertices is split by all.
TEST(Known, LongChannels) {
  constexpr int n = 300;
  LatticeGraph graph;
  for (int i = 0; i < n; ++i) {
    graph.points.push_back({{3.0 * i, 20.0 + (i * i) % 7}});
    graph.points.push_back({{3.0 * i + 1, -20.0 - (i * i) % 5}});
  }
  graph.points.push_back({{-400, 0}});
  graph.points.push_back({{3.0 * n + 400, 0}});
  graph.segments.push_back({2 * n, 2 * n + 1});
  const auto swapped = run(graph, Domain::hull, Recovery::swaps), filled = run(graph, Domain::hull);
  expect_valid(graph, Domain::hull, swapped);
  expect_valid(graph, Domain::hull, filled);
  EXPECT_GT(swapped.swaps, n);
  for (int i = 0; i < n; ++i) graph.points.push_back({{3.0 * i, 0}});
  const auto split = run(graph, Domain::hull);
  expect_valid(graph, Domain::hull, split);
  EXPECT_EQ(split.touches.size(), static_cast<std::size_t>(n));
  EXPECT_EQ(split.constraints.size(), static_cast<std::size_t>(n + 1));
}

TEST(Known, CollinearPointsHoldTheirSegments) {
  const LatticeGraph graph{{{{0, 0}}, {{2, 2}}, {{1, 1}}}, {{0, 1}}, {}};
  const auto t = run(graph, Domain::hull);
  EXPECT_EQ(t.mesh.outcome, Outcome::ok);
  EXPECT_EQ(t.mesh.edges, (std::vector<Edge>{{0, 2}, {2, 1}}));
  EXPECT_EQ(run(graph, Domain::carved).mesh.outcome, Outcome::refused_input);
}

TEST(Known, NoPoints) { EXPECT_EQ(run({}, Domain::hull).mesh.outcome, Outcome::refused_input); }

TEST(Known, CoastByBothRecoveries) {
  LatticeGraph graph;
  graph.points = find_dataset("coast")->generate(850, 1);
  graph.segments = coast_segments();
  for (const Recovery recovery : {Recovery::swaps, Recovery::cavity}) {
    const auto t = run(graph, Domain::hull, recovery, Order::brio);
    expect_valid(graph, Domain::hull, t);
    EXPECT_GE(t.constraints.size(), graph.segments.size());
  }
}

}  // namespace
}  // namespace tribunal
