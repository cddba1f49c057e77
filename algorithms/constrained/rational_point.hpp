// Points whose coordinates are rational numbers: where segments cross.
#pragma once

#include "predicates/point.hpp"

#include <gmpxx.h>

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

}  // namespace tribunal
