// Experiment `greedy-quality`: the angles and the total length of the greedy triangulation beside Delaunay's.
//
// On the distinct points of one dataset. Counters: `runs` (1); `greedy.min_angle`, `delaunay.min_angle`
// (degrees); `larger_min`, `smaller_min` (1 where greedy's smallest angle is larger, or smaller, compared
// exactly); `greedy.length`,
// `delaunay.length` (rounded sums); `different` (edges of the greedy triangulation that the other has not);
// `edges`.
#include "algorithms/flips/angles.hpp"
#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/dataset.hpp"

#include <cmath>
#include <set>
#include <vector>

namespace tribunal::bench {
namespace {

std::set<Edge> edges_of(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.insert(undirected(t[i], t[(i + 1) % 3]));
  return edges;
}

double total_length(const std::vector<Point2>& points, const std::set<Edge>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges)
    sum += std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1]);
  return sum;
}

Finding run_greedy_quality(const Cell& cell) {
  const std::vector<Point2> points = distinct_points(cell_points(cell));
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const std::vector<Index> order = insertion_order(points, Order::random, cell.seed);
  std::vector<Triangle> meshes[2];
  for (const int i : {0, 1}) {
    const PlanarAlgorithm& algorithm = *find_planar_algorithm(i == 0 ? "greedy" : "green-sibson");
    Triangulation t = triangulate(points, order, kernel, algorithm);
    if (t.outcome != Outcome::ok) return {t.outcome, t.reason};
    if (t.dimension < 2) return {Outcome::refused_input, "all points are on a line"};
    meshes[i] = std::move(t.triangles);
  }
  const Sites sites{points, kernel};
  const Triangle greedy = smallest_corner(sites, meshes[0]), delaunay = smallest_corner(sites, meshes[1]);
  const std::set<Edge> greedy_edges = edges_of(meshes[0]), delaunay_edges = edges_of(meshes[1]);
  double different = 0;
  for (const Edge& edge : greedy_edges) different += !delaunay_edges.contains(edge);
  return {.counters = {{"runs", 1},
                       {"greedy.min_angle", degrees(sites, greedy)},
                       {"delaunay.min_angle", degrees(sites, delaunay)},
                       {"larger_min", sites.compare_angle(greedy, delaunay) == Sign::positive},
                       {"smaller_min", sites.compare_angle(greedy, delaunay) == Sign::negative},
                       {"greedy.length", total_length(points, greedy_edges)},
                       {"delaunay.length", total_length(points, delaunay_edges)},
                       {"different", different},
                       {"edges", static_cast<double>(greedy_edges.size())}}};
}

}  // namespace

constinit const Experiment greedy_quality_experiment{
    .name = "greedy-quality",
    .cites = "Barth, section 3.4",
    .summary = "smallest angle and total length of the greedy triangulation beside Delaunay's",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_greedy_quality,
};

}  // namespace tribunal::bench
