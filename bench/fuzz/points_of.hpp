// The points of many cases in one row.
#pragma once

#include "bench/fuzz/case.hpp"

#include <span>
#include <vector>

namespace tribunal::bench::fuzz {

/// The points of the cases, all of dimension D, one case after the other.
template <int D>
std::vector<Point<D>> points_of_all(std::span<const Case> cases) {
  std::vector<Point<D>> points;
  points.reserve(cases.size() * (D + 2));
  for (const Case& asked : cases)
    for (int i = 0; i < asked.points(); ++i) points.push_back(point_of<D>(asked, i));
  return points;
}

}  // namespace tribunal::bench::fuzz
