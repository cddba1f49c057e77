// Experiment `truncation`: what cutting the coordinates to fewer bits does to a Delaunay triangulation.
//
// The dataset as it is and rounded to the lattice [0, 2^bits)^2, both triangulated in the cell's order. Sites
// that fall together are one; an edge is looked for between the sites that its ends became.
//
// Counters: `sites`, distinct before; `merged`, sites that fell on another one; `edges`, of the first
// triangulation; `edges_lost`, those among them that the second has not (its ends merged, or flipped away);
// for the dataset `coast` its `segments`, and `crossings`, pairs of segments that cross in their interiors
// after rounding and did not before.
#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/dataset.hpp"
#include "datasets/real.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace tribunal::bench {
namespace {

/// For each point the first one at the same place.
std::vector<Index> first_occurrences(std::span<const Point2> points) {
  std::map<Point2, Index> seen;
  std::vector<Index> first;
  for (Index i = 0; i < points.size(); ++i) first.push_back(seen.try_emplace(points[i], i).first->second);
  return first;
}

std::set<Edge> edges_of(const Triangulation& t) {
  std::set<Edge> edges;
  for (const Triangle& triangle : t.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.insert({a, b});
    }
  return edges;
}

bool cross(const Kernel2& kernel, std::span<const Point2> p, Edge s, Edge t) {
  const auto opposite = [&](Edge line, Edge ends) {
    return kernel.orient2d(p[line[0]], p[line[1]], p[ends[0]]) *
               kernel.orient2d(p[line[0]], p[line[1]], p[ends[1]]) ==
           Sign::negative;
  };
  return opposite(s, t) && opposite(t, s);
}

double crossings(const Kernel2& kernel, std::span<const Point2> points, std::span<const Edge> segments) {
  double count = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) count += cross(kernel, points, segments[i], segments[j]);
  return count;
}

Finding run_truncation(const Cell& cell) {
  if (cell.bits == 0) return {Outcome::refused_input, "bits says how many are kept; it is not 0"};
  Cell whole = cell;
  whole.bits = 0;
  const std::vector<Point2> before = cell_points(whole), after = quantise(before, cell.bits);
  const Kernel2Binding bound_before = cell_kernel(before, cell), bound_after = cell_kernel(after, cell);
  for (const auto* binding : {&bound_before, &bound_after})
    if (const auto* refusal = std::get_if<Refusal>(binding))
      return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2 &kernel_before = *std::get<0>(bound_before), &kernel_after = *std::get<0>(bound_after);
  const auto order = cell_order(before, cell, cell.order_seed);
  const PlanarAlgorithm& algorithm = *find_planar_algorithm("green-sibson");
  const Triangulation first = triangulate(before, order, kernel_before, algorithm);
  const Triangulation second = triangulate(after, order, kernel_after, algorithm);
  if (first.outcome != Outcome::ok) return {first.outcome, first.reason};
  if (second.outcome != Outcome::ok) return {second.outcome, second.reason};

  const auto site = first_occurrences(after);
  const std::set<Edge> edges = edges_of(first), kept = edges_of(second);
  const auto lost = std::count_if(edges.begin(), edges.end(), [&](const Edge& e) {
    const auto [a, b] = std::minmax(site[e[0]], site[e[1]]);
    return !kept.contains({a, b});
  });
  const auto sites_before = before.size() - first.duplicates.size();
  const auto sites_after = after.size() - second.duplicates.size();
  Finding finding{.counters = {{"sites", static_cast<double>(sites_before)},
                               {"merged", static_cast<double>(sites_before - sites_after)},
                               {"edges", static_cast<double>(edges.size())},
                               {"edges_lost", static_cast<double>(lost)}}};
  if (cell.dataset == "coast" && before.size() == find_dataset("coast")->about.fixed_size) {
    const auto segments = coast_segments();
    finding.counters["segments"] = static_cast<double>(segments.size());
    finding.counters["crossings"] =
        crossings(kernel_after, after, segments) - crossings(kernel_before, before, segments);
  }
  return finding;
}

}  // namespace

constinit const Experiment truncation_experiment{
    .name = "truncation",
    .cites = "Barth, section 3.7",
    .summary = "sites merged, edges lost and constraints crossed when coordinates are cut to fewer bits",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true, .order = true},
    .parameters = {},
    .run = run_truncation,
};

}  // namespace tribunal::bench
