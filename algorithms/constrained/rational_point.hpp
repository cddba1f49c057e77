// Points whose coordinates are rational numbers: where segments cross.
#pragma once

#include "predicates/point.hpp"

#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

namespace tribunal {

struct RationalPoint {
  mpq_class x, y;
  friend bool operator==(const RationalPoint& a, const RationalPoint& b) { return a.x == b.x && a.y == b.y; }
  /// Lexicographic, as of points.
  friend bool operator<(const RationalPoint& a, const RationalPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

inline RationalPoint rational(Point2 p) { return {mpq_class(p[0]), mpq_class(p[1])}; }

/// Where the lines ab and cd meet, which are not parallel. Exact.
RationalPoint intersection(Point2 a, Point2 b, Point2 c, Point2 d);

/// The nearest doubles, ties to even; the coordinates are in the range of doubles.
Point2 nearest(const RationalPoint& p);

/// The numbers that a coordinate may be rounded to: those of fewer places than doubles have, none of them
/// finer than a unit, and some that are there already. Rounding to the nearest of a fixed set is monotone,
/// and keeps what is in it.
class CoarseNumbers {
 public:
  /// Of coordinates that are there, not none. `dropped` of the 53 binary places are left out, from 0 on; the
  /// finest unit is that of the last place of the largest coordinate, times 2^exponent.
  CoarseNumbers(std::span<const Point2> points, int dropped, int exponent);

  /// The nearest ones, ties downwards; p lies in the box of the points. O(log n).
  Point2 nearest(const RationalPoint& p) const;

 private:
  double nearest_of(const mpq_class& value, const std::vector<double>& kept) const;

  int dropped_;
  double finest_;
  std::array<std::vector<double>, 2> kept_;  ///< by axis, sorted
};

}  // namespace tribunal
