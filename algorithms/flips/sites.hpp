// Points and the kernel bound to them, asked by index: what criteria of flips see of the geometry.
#pragma once

#include "algorithms/triangulation.hpp"
#include "predicates/kernel.hpp"

#include <span>

namespace tribunal {

struct Sites {
  std::span<const Point2> points;
  const Kernel2& kernel;

  Sign orient(Index a, Index b, Index c) const { return kernel.orient2d(points[a], points[b], points[c]); }
  Sign incircle(Index a, Index b, Index c, Index d) const {
    return kernel.incircle(points[a], points[b], points[c], points[d]);
  }
  Sign compare_length(Index a, Index b, Index c, Index d) const {
    return kernel.compare_length(points[a], points[b], points[c], points[d]);
  }
  /// Of two corners, each a triangle read from its second vertex: {a, apex, b}.
  Sign compare_angle(const Triangle& p, const Triangle& q) const {
    return kernel.compare_angle({points[p[0]], points[p[1]], points[p[2]]},
                                {points[q[0]], points[q[1]], points[q[2]]});
  }
};

}  // namespace tribunal
