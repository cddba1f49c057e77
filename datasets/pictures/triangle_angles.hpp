// Angles of triangles for the eye: in doubles, decided upon by nobody.
#pragma once

#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

namespace tribunal::pictures {

/// The angle at p between q and r, in degrees; that of a needle where the doubles tell no direction.
inline double angle_at(const Point2& p, const Point2& q, const Point2& r) {
  // Halves, so that no difference overflows.
  const double qx = q[0] / 2 - p[0] / 2, qy = q[1] / 2 - p[1] / 2;
  const double rx = r[0] / 2 - p[0] / 2, ry = r[1] / 2 - p[1] / 2;
  const double q_length = std::hypot(qx, qy), r_length = std::hypot(rx, ry);
  if (!(q_length > 0 && r_length > 0)) return 0;
  const double ux = qx / q_length, uy = qy / q_length, vx = rx / r_length, vy = ry / r_length;
  return std::atan2(std::fabs(ux * vy - uy * vx), ux * vx + uy * vy) * 180 / std::numbers::pi;
}

/// From the smallest to the largest.
inline std::array<double, 3> angles_of(std::span<const Point2> points,
                                       const std::array<std::uint32_t, 3>& triangle) {
  const Point2 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  std::array angles{angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)};
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Degrees in bands of equal width, from the best angle to the worst.
struct AngleScale {
  double best, worst;
  std::size_t bands;
  std::size_t band(double angle) const {
    const double where = std::clamp((angle - best) / (worst - best), 0.0, 1.0);
    return std::min(bands - 1, static_cast<std::size_t>(where * static_cast<double>(bands)));
  }
};
inline constexpr AngleScale largest_angles{60, 180, 12}, smallest_angles{60, 0, 12};

}  // namespace tribunal::pictures
