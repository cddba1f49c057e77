#include "algorithms/verify/sites.hpp"

#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>
#include <numeric>

namespace tribunal::verify {
namespace {

int affine_dimension(std::span<const Point2> points, std::span<const std::uint32_t> sorted) {
  if (sorted.size() < 3) return static_cast<int>(sorted.size()) - 1;
  const Point2 first = points[sorted.front()], last = points[sorted.back()];
  const bool collinear = std::all_of(sorted.begin(), sorted.end(), [&](std::uint32_t site) {
    return orientation(first, last, points[site]) == Sign::zero;
  });
  return collinear ? 1 : 2;
}

/// Appends the chain that turns left or goes straight from the first to the last of `range`, the last left
/// out.
template <class Range>
void append_chain(std::span<const Point2> points, const Range& range, std::vector<std::uint32_t>& chain) {
  const std::size_t start = chain.size();
  for (const std::uint32_t site : range) {
    while (chain.size() >= start + 2 &&
           orientation(points[chain[chain.size() - 2]], points[chain.back()], points[site]) == Sign::negative)
      chain.pop_back();
    chain.push_back(site);
  }
  chain.pop_back();
}

}  // namespace

Sites find_sites(std::span<const Point2> points) {
  Sites sites;
  sites.representative.resize(points.size());
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a] == points[b] ? a < b : points[a] < points[b];
  });
  for (const std::uint32_t point : order) {
    if (sites.sorted.empty() || !(points[sites.sorted.back()] == points[point]))
      sites.sorted.push_back(point);
    sites.representative[point] = sites.sorted.back();
  }
  sites.dimension = affine_dimension(points, sites.sorted);
  return sites;
}

std::vector<std::uint32_t> convex_hull(std::span<const Point2> points, const Sites& sites) {
  std::vector<std::uint32_t> hull;
  append_chain(points, sites.sorted, hull);
  append_chain(points, std::vector<std::uint32_t>(sites.sorted.rbegin(), sites.sorted.rend()), hull);
  return hull;
}

}  // namespace tribunal::verify
