// Integer points and the signs of the tests, in 128-bit integers: nothing is shared with the checker under
// test.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace tribunal::faults {

__extension__ using Wide = __int128;

/// A point with |coordinates| < 2^28, so that the four-fold products below stay under 2^125.
struct LatticePoint {
  std::int64_t x, y;
  friend constexpr auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// Twice the signed area: positive when a, b, c turn counter-clockwise.
constexpr Wide area(LatticePoint a, LatticePoint b, LatticePoint c) {
  return Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
}

/// Positive when d is strictly inside the circle of the counter-clockwise a, b, c: the lifted determinant.
constexpr Wide in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto lift = [d](LatticePoint p) {
    return Wide{p.x - d.x} * (p.x - d.x) + Wide{p.y - d.y} * (p.y - d.y);
  };
  return lift(a) * area(d, b, c) - lift(b) * area(d, a, c) + lift(c) * area(d, a, b);
}

/// q lies on the segment ab and is none of its ends.
constexpr bool inside_segment(LatticePoint a, LatticePoint b, LatticePoint q) {
  return area(a, b, q) == 0 && ((a < q && q < b) || (b < q && q < a));
}

/// ab and cd have one point in common, and it is an end of neither.
constexpr bool cross_properly(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto apart = [](Wide s, Wide t) { return (s < 0 && t > 0) || (s > 0 && t < 0); };
  return apart(area(a, b, c), area(a, b, d)) && apart(area(c, d, a), area(c, d, b));
}

/// q lies strictly inside the triangle abc, whichever way that turns.
constexpr bool inside_triangle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint q) {
  const Wide s = area(a, b, q), t = area(b, c, q), u = area(c, a, q);
  return (s > 0 && t > 0 && u > 0) || (s < 0 && t < 0 && u < 0);
}

/// The same points as doubles; exact.
inline std::vector<Point2> as_points(const std::vector<LatticePoint>& lattice) {
  std::vector<Point2> points;
  for (const LatticePoint& p : lattice)
    points.push_back({{static_cast<double>(p.x), static_cast<double>(p.y)}});
  return points;
}

}  // namespace tribunal::faults
