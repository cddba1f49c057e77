// The point set behind a mesh: distinct sites, its dimension and its convex hull.
#pragma once

#include "predicates/point.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::verify {

struct Sites {
  std::vector<std::uint32_t> sorted;  ///< the distinct sites in lexicographic order, by their first index
  std::vector<std::uint32_t> representative;  ///< of each point: the first index with its position
  int dimension;                              ///< -1 (none), 0, 1 or 2
};

/// Merges equal positions and finds the dimension. O(n log n).
Sites find_sites(std::span<const Point2> points);

/// Counter-clockwise boundary of the convex hull of sites of dimension 2, all sites on it included, from the
/// lexicographically least: Andrew's monotone chain (1979) that turns only at strict right turns. O(n).
std::vector<std::uint32_t> convex_hull(std::span<const Point2> points, const Sites& sites);

}  // namespace tribunal::verify
