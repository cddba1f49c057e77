// The points of many cases in one row.
#pragma once

#include "bench/fuzz/case.hpp"

#include <span>
#include <vector>

namespace tribunal::bench {

/// The points of the cases, all of dimension D, one case after the other.
template <int D>
std::vector<Point<D>> points_of_all(std::span<const fuzz::Case> cases) {
  std::vector<Point<D>> points;
  for (const fuzz::Case& asked : cases)
    for (int i = 0; i < asked.points(); ++i) points.push_back(fuzz::point_of<D>(asked, i));
  return points;
}

}  // namespace tribunal::bench
