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

/// And the smallest, in degrees.
inline double smallest_degrees(const Sites& sites, std::span<const Triangle> triangles) {
  double smallest = 180;
  for (const auto& [a, b, c] : triangles)
    for (const Triangle& corner : {Triangle{a, b, c}, {b, c, a}, {c, a, b}})
      smallest = std::min(smallest, degrees(sites, corner));
  return smallest;
}

}  // namespace tribunal
