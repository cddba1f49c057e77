// Angles as numbers, to be shown; decisions compare them exactly.
#pragma once

#include "algorithms/direction.hpp"
#include "algorithms/flips/min_max_criterion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tribunal {

/// Of the corner {a, apex, b}, in degrees, rounded.
inline double degrees(const Sites& sites, const Triangle& corner) {
  const auto &a = sites.points[corner[0]], &apex = sites.points[corner[1]], &b = sites.points[corner[2]];
  const auto [ux, uy] = direction(apex, a);
  const auto [vx, vy] = direction(apex, b);
  return std::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy) * 180 / std::numbers::pi;
}

/// The corner with the largest angle of all.
inline Triangle largest_corner(const Sites& sites, std::span<const Triangle> triangles) {
  Triangle largest = largest_corner(sites, triangles[0]);
  for (const Triangle& t : triangles)
    if (const Triangle corner = largest_corner(sites, t);
        sites.compare_angle(corner, largest) == Sign::positive)
      largest = corner;
  return largest;
}

/// The corner {a, apex, b} of the triangle with the smallest angle: the one across from its shortest side. Of
/// equal ones the first in the triangle.
inline Triangle smallest_corner(const Sites& sites, const Triangle& t) {
  std::size_t shortest = 0;  // side i runs from t[i] to t[i + 1]
  for (std::size_t i = 1; i < 3; ++i)
    if (sites.compare_length(t[i], t[(i + 1) % 3], t[shortest], t[(shortest + 1) % 3]) == Sign::negative)
      shortest = i;
  return {t[shortest], t[(shortest + 2) % 3], t[(shortest + 1) % 3]};
}

/// And the one with the smallest.
inline Triangle smallest_corner(const Sites& sites, std::span<const Triangle> triangles) {
  Triangle smallest = smallest_corner(sites, triangles[0]);
  for (const Triangle& t : triangles)
    if (const Triangle corner = smallest_corner(sites, t);
        sites.compare_angle(corner, smallest) == Sign::negative)
      smallest = corner;
  return smallest;
}

}  // namespace tribunal
