// Experiment `minimum-weight`: greedy and Delaunay triangulations against the shortest of all.
//
// The shortest is found among all triangulations of a small set of integer points. `points` chooses the set:
// two that are fixed, on which greedy and Delaunay are beaten, or `sets` random ones of `sites` points in [0,
// 64)^2, drawn with the seed.
//
// Counters, sums over the sets: `sets`; `greedy`, `delaunay` and `minimum` (total lengths, rounded);
// `greedy_beaten` and `delaunay_beaten` (sets on which the shortest is shorter by more than rounding).
#include "bench/experiments/all_triangulations.hpp"
#include "bench/experiments/greedy_methods.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace tribunal::bench {
namespace {

constexpr Parameter points_parameter{
    .name = "points", .summary = "which sets", .standard = "random", .choices = [] {
      return std::vector<std::string_view>{"random", "greedy-beaten", "delaunay-beaten"};
    }};
constexpr Parameter sites_parameter{
    .name = "sites", .summary = "points in a random set", .standard = "7", .least = 4, .most = 8};
constexpr Parameter sets_parameter{
    .name = "sets", .summary = "how many random sets", .standard = "100", .least = 1, .most = 100'000};
constexpr std::array parameters{points_parameter, sites_parameter, sets_parameter};

using PointSet = std::vector<Point2>;

PointSet draw(std::size_t n, Random& random) {
  std::set<Point2> points;
  while (points.size() < n)
    points.insert({static_cast<double>(random.below(64)), static_cast<double>(random.below(64))});
  PointSet set(points.begin(), points.end());
  random.shuffle(std::span(set));
  return set;
}

std::vector<PointSet> chosen_sets(const Cell& cell) {
  const std::string which = choice(cell.parameters, points_parameter);
  if (which == "greedy-beaten") return {{{0, 18}, {10, 19}, {17, 12}, {5, 20}, {7, 20}, {14, 17}}};
  if (which == "delaunay-beaten") return {{{9, 12}, {12, 0}, {11, 7}, {4, 11}, {12, 3}}};
  Random random(cell.seed);
  std::vector<PointSet> sets;
  for (auto left = whole_number(cell.parameters, sets_parameter); left > 0; --left)
    sets.push_back(draw(whole_number(cell.parameters, sites_parameter), random));
  return sets;
}

double length(const PointSet& points, const Edge& e) {
  const double x = points[e[0]][0] - points[e[1]][0], y = points[e[0]][1] - points[e[1]][1];
  return std::sqrt(x * x + y * y);
}

/// Summed in one order, whatever order the edges come in: equal sets of edges have equal sums.
double weight(const PointSet& points, std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  return std::accumulate(edges.begin(), edges.end(), 0.0,
                         [&](double sum, const Edge& e) { return sum + length(points, e); });
}

std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.insert(undirected(t[i], t[(i + 1) % 3]));
  return {edges.begin(), edges.end()};
}

struct Weights {
  double greedy = 0, delaunay = 0, minimum = 0;
};

Weights weigh(const PointSet& points, const PlanarProblem& problem) {
  const GreedyAnswer greedy = greedy_answers({problem})[2];
  const std::vector<Triangle> delaunay = find_planar_algorithm("green-sibson")->run(problem).triangles;
  Weights weights{weight(points, greedy.found.edges), weight(points, edges_of(delaunay))};
  weights.minimum = weights.greedy;
  visit_all_triangulations({points, problem.kernel}, greedy.triangles, [&](const auto& triangles) {
    weights.minimum = std::min(weights.minimum, weight(points, edges_of(triangles)));
  });
  return weights;
}

Finding run_minimum_weight(const Cell& cell) {
  constexpr double beyond_rounding = 1e-9;
  Finding finding;
  for (const PointSet& points : chosen_sets(cell)) {
    const Kernel2Binding binding = cell_kernel(points, cell);
    if (const auto* refusal = std::get_if<Refusal>(&binding))
      return {Outcome::out_of_domain, describe(*refusal)};
    const Kernel2& kernel = *std::get<0>(binding);
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto turns = std::find_if(order.begin() + 2, order.end(), [&](Index v) {
      return kernel.orient2d(points[0], points[1], points[v]) != Sign::zero;
    });
    if (turns == order.end()) continue;
    std::iter_swap(order.begin() + 2, turns);
    const Weights weights = weigh(points, {points, order, kernel});
    ++finding.counters["sets"];
    finding.counters["greedy"] += weights.greedy;
    finding.counters["delaunay"] += weights.delaunay;
    finding.counters["minimum"] += weights.minimum;
    finding.counters["greedy_beaten"] += weights.minimum < weights.greedy * (1 - beyond_rounding);
    finding.counters["delaunay_beaten"] += weights.minimum < weights.delaunay * (1 - beyond_rounding);
  }
  return finding;
}

}  // namespace

constinit const Experiment minimum_weight_experiment{
    .name = "minimum-weight",
    .cites = "Barth, section 3.4",
    .summary = "total lengths of greedy and Delaunay triangulations against the least there is",
    .reads = {.backend = true, .seed = true},
    .parameters = parameters,
    .run = run_minimum_weight,
};

}  // namespace tribunal::bench
