// Where queries may lie once a kernel is bound: around the data, with room for points that algorithms
// construct.
#pragma once

#include "predicates/domain.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace tribunal {

/// The bounding box of a point set, extended to each side by a quarter of its greatest width. Without points,
/// all of space.
class WorkingBox {
 public:
  /// The box around the points, which must be finite. O(n).
  template <int D>
  static WorkingBox around(std::span<const Point<D>> points) {
    static_assert(D <= 3);
    WorkingBox box;
    if (points.empty()) return box;
    double widest = 0;
    for (int axis = 0; axis < D; ++axis) {
      const auto [lowest, highest] = std::minmax_element(
          points.begin(), points.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      box.lowest_[axis] = (*lowest)[axis];
      box.highest_[axis] = (*highest)[axis];
      widest = std::max(widest, box.highest_[axis] - box.lowest_[axis]);
    }
    for (int axis = 0; axis < D; ++axis) {
      box.lowest_[axis] -= widest / 4;
      box.highest_[axis] += widest / 4;
    }
    // One and a half in exact arithmetic; the rest covers what rounding added.
    box.width_ = 2 * widest;
    return box;
  }

  /// Whether p is finite and in the box.
  template <int D>
  bool contains(const Point<D>& p) const {
    for (int axis = 0; axis < D; ++axis)
      if (!(lowest_[axis] <= p[axis] && p[axis] <= highest_[axis])) return false;
    return is_finite(p);
  }

  /// No rounded difference of coordinates of points in the box is greater; infinite where they could
  /// overflow.
  double width() const { return width_; }

 private:
  WorkingBox() {
    lowest_.fill(-std::numeric_limits<double>::infinity());
    highest_.fill(std::numeric_limits<double>::infinity());
  }

  std::array<double, 3> lowest_, highest_;
  double width_ = std::numeric_limits<double>::infinity();
};

}  // namespace tribunal
