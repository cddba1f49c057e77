// Points with finite double coordinates, and the exact comparisons that need no arithmetic.
#pragma once

#include <array>
#include <cstddef>

namespace tribunal {

/// A site in D dimensions. Plain data: two of them pass in registers in the plane.
template <int D>
struct Point {
  static constexpr int dimension = D;
  std::array<double, D> coordinate;

  constexpr double operator[](std::size_t axis) const { return coordinate[axis]; }
  constexpr double& operator[](std::size_t axis) { return coordinate[axis]; }

  /// Equality of positions: -0 equals +0. A set of points is one with no two equal.
  friend constexpr bool operator==(const Point& a, const Point& b) { return a.coordinate == b.coordinate; }

  /// Lexicographic order by x, then y, then z. On one line it is the order along the line, so it decides
  /// betweenness of collinear points without any arithmetic.
  friend constexpr bool operator<(const Point& a, const Point& b) { return a.coordinate < b.coordinate; }
};

using Point2 = Point<2>;
using Point3 = Point<3>;

/// True when q, known to be collinear with a and b, lies strictly between them. Exact.
template <int D>
constexpr bool strictly_between(const Point<D>& a, const Point<D>& q, const Point<D>& b) {
  return (a < q && q < b) || (b < q && q < a);
}

}  // namespace tribunal
