// What most generators do: n points, one after the other.
#pragma once

#include "predicates/point.hpp"

#include <cstdint>
#include <vector>

namespace tribunal::generators {

/// The points place(0), ..., place(n-1), drawn in this order.
template <class Place>
std::vector<Point2> each(std::uint64_t n, Place place) {
  std::vector<Point2> points;
  points.reserve(n);
  for (std::uint64_t i = 0; i < n; ++i) points.push_back(place(i));
  return points;
}

}  // namespace tribunal::generators
