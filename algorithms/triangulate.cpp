#include "algorithms/triangulate.hpp"

#include "algorithms/abandon.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace tribunal {
namespace {

/// For each index, the first index with an equal point.
std::vector<Index> first_occurrences(std::span<const Point2> points) {
  std::vector<Index> by_position(points.size()), first(points.size());
  std::iota(by_position.begin(), by_position.end(), Index{0});
  std::sort(by_position.begin(), by_position.end(), [&](Index a, Index b) {
    if (points[a] == points[b]) return a < b;
    return points[a] < points[b];
  });
  for (std::size_t i = 0; i < by_position.size(); ++i) {
    const Index v = by_position[i];
    const bool repeated = i > 0 && points[by_position[i - 1]] == points[v];
    first[v] = repeated ? first[by_position[i - 1]] : v;
  }
  return first;
}

/// Distinct sites in the order of their first visit; notes the rest in result.duplicates.
std::vector<Index> merge_duplicates(std::span<const Point2> points, std::span<const Index> order,
                                    Triangulation& result) {
  const std::vector<Index> first = first_occurrences(points);
  std::vector<bool> seen(points.size(), false);
  std::vector<Index> sites;
  sites.reserve(points.size());
  for (const Index v : order) {
    if (!seen[first[v]]) sites.push_back(first[v]);
    seen[first[v]] = true;
  }
  for (Index v = 0; v < first.size(); ++v)
    if (first[v] != v) result.duplicates.emplace_back(v, first[v]);
  return sites;
}

/// The path through collinear sites, in lexicographic order, which is the order along their line.
void connect_collinear(std::span<const Point2> points, std::vector<Index> sites, Triangulation& result) {
  std::sort(sites.begin(), sites.end(), [&](Index a, Index b) { return points[a] < points[b]; });
  for (std::size_t i = 1; i < sites.size(); ++i) result.edges.push_back({sites[i - 1], sites[i]});
  result.dimension = sites.size() > 1 ? 1 : 0;
  result.hull = sites.size();
}

}  // namespace

Triangulation triangulate(std::span<const Point2> points, std::span<const Index> order, const Kernel2& kernel,
                          const PlanarAlgorithm& algorithm, const Settings& settings,
                          std::span<const double> values) {
  assert(order.size() == points.size());
  assert(values.empty() || values.size() == points.size());
  Triangulation front;
  front.reason = refuse_settings(algorithm.about.name, algorithm.parameters, settings);
  if (!front.reason.empty()) {
    front.outcome = Outcome::refused_input;
    return front;
  }
  if (points.empty() || points.size() >= 0xFFFFFFFF / 3) {
    front.outcome = Outcome::refused_input;
    front.reason = points.empty() ? "there are no points" : "more points than 32-bit indices can serve";
    return front;
  }
  std::vector<Index> sites = merge_duplicates(points, order, front);
  std::size_t third = 2;
  while (third < sites.size() &&
         kernel.orient2d(points[sites[0]], points[sites[1]], points[sites[third]]) == Sign::zero)
    ++third;
  if (third >= sites.size()) {
    connect_collinear(points, std::move(sites), front);
    return front;
  }
  std::rotate(sites.begin() + 2, sites.begin() + static_cast<std::ptrdiff_t>(third),
              sites.begin() + static_cast<std::ptrdiff_t>(third) + 1);

  Triangulation result;
  try {
    result = algorithm.run({points, sites, kernel, settings, values});
  } catch (const Abandon& abandon) {
    result.outcome = abandon.outcome;
    result.reason = abandon.what();
  }
  result.dimension = 2;
  result.duplicates = std::move(front.duplicates);
  return result;
}

}  // namespace tribunal
