#include "bench/normalise.hpp"

#include "algorithms/mesh/canonical.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/formulas/orient.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tribunal::bench {

std::vector<Index> first_copies(std::span<const Point2> points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return points[a] < points[b]; });
  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::vector<Triangle> normalise(std::span<const Point2> points, std::vector<Triangle> triangles) {
  const std::vector<Index> first = first_copies(points);
  for (Triangle& t : triangles) {
    if (std::ranges::any_of(t, [&](Index corner) { return corner >= points.size(); })) continue;
    for (Index& corner : t) corner = first[corner];
    if (exact_sign<Orient<2>>({points[t[0]], points[t[1]], points[t[2]]}) == Sign::negative)
      std::swap(t[1], t[2]);
  }
  return canonical(triangles);
}

}  // namespace tribunal::bench
