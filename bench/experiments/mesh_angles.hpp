// The extreme shapes of a mesh, for experiments to report.
#pragma once

#include "algorithms/triangulation.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tribunal::bench {

struct MeshShape {
  double largest_angle = 0;  ///< in degrees
  double aspect = 0;         ///< the largest ratio of a longest edge to the height over it
};

/// Rounded.
inline MeshShape shape_of(std::span<const Point2> points, std::span<const Triangle> triangles) {
  MeshShape shape;
  for (const Triangle& t : triangles) {
    double longest = 0, area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 &o = points[t[i]], &a = points[t[(i + 1) % 3]], &b = points[t[(i + 2) % 3]];
      const double ux = a[0] - o[0], uy = a[1] - o[1], vx = b[0] - o[0], vy = b[1] - o[1];
      area = std::abs(ux * vy - uy * vx);
      longest = std::max(longest, ux * ux + uy * uy);
      const double angle = std::atan2(area, ux * vx + uy * vy) * 180 / std::numbers::pi;
      shape.largest_angle = std::max(shape.largest_angle, angle);
    }
    shape.aspect = std::max(shape.aspect, longest / area);
  }
  return shape;
}

}  // namespace tribunal::bench
