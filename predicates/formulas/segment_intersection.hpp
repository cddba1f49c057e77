// How two segments in the plane meet, from the signs of orientations alone.
#pragma once

#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace tribunal {

enum class SegmentIntersection : std::uint8_t {
  disjoint,  ///< no point in common
  touching,  ///< one point in common, an end of at least one of them
  crossing,  ///< one point in common, inside both
  overlap,   ///< a segment in common
};

/// How the segments ab and cd meet, a != b and c != d. `kernel` answers orient2d: a Kernel2, or anything that
/// does; it is asked four times at most.
template <class Kernel>
SegmentIntersection intersect_segments(const Kernel& kernel, Point2 a, Point2 b, Point2 c, Point2 d) {
  assert(!(a == b) && !(c == d));
  const Sign abc = kernel.orient2d(a, b, c), abd = kernel.orient2d(a, b, d);
  if (abc == Sign::zero && abd == Sign::zero) {
    // On one line, where the lexicographic order is the order along it.
    const Point2 start = std::max(std::min(a, b), std::min(c, d)),
                 end = std::min(std::max(a, b), std::max(c, d));
    return end < start    ? SegmentIntersection::disjoint
           : start == end ? SegmentIntersection::touching
                          : SegmentIntersection::overlap;
  }
  if (abc == abd) return SegmentIntersection::disjoint;
  const Sign cda = kernel.orient2d(c, d, a), cdb = kernel.orient2d(c, d, b);
  if (cda == cdb) return SegmentIntersection::disjoint;
  // Each meets the other's line, in the one point that the lines have in common.
  const bool proper = abc == -abd && cda == -cdb;
  return proper ? SegmentIntersection::crossing : SegmentIntersection::touching;
}

}  // namespace tribunal
