// Directions as numbers, for angles that are shown or estimated; decisions are signs.
#pragma once

#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribunal {

/// From one point to another, scaled by a power of two to a length between 1 and 3, so that products stay in
/// the range of doubles; zero where they coincide. Finite points may be farther apart than doubles reach.
inline std::array<double, 2> direction(Point2 from, Point2 to) {
  double x = to[0] - from[0], y = to[1] - from[1];
  if (!std::isfinite(x) || !std::isfinite(y)) x = to[0] / 2 - from[0] / 2, y = to[1] / 2 - from[1] / 2;
  const double longer = std::max(std::fabs(x), std::fabs(y));
  if (longer == 0) return {0, 0};
  const int exponent = std::ilogb(longer);
  return {std::ldexp(x, -exponent), std::ldexp(y, -exponent)};
}

}  // namespace tribunal
