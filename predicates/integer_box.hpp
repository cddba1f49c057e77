// The domain of backends that compute with small integers as they are.
#pragma once

#include "predicates/domain.hpp"
#include "predicates/kernel.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace tribunal {

/// The box of points with integer coordinates. Differences within it are exact and at most its width.
template <int D>
class IntegerBox {
 public:
  /// The box of the points, or the first of them that is not of integers or makes it wider than `width` <
  /// 2^53.
  static Binding<IntegerBox> find(std::span<const Point<D>> points, double width) {
    if (auto refusal = refuse_environment()) return *refusal;
    IntegerBox box;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_finite(points[i])) return Refusal{i, "a coordinate is not finite"};
      for (int axis = 0; axis < D; ++axis) {
        const double x = points[i][axis];
        if (!is_integer(x)) return Refusal{i, name_coordinate(axis, x) + " is no integer"};
        box.lowest_[axis] = std::min(box.lowest_[axis], x);
        box.highest_[axis] = std::max(box.highest_[axis], x);
        if (box.highest_[axis] - box.lowest_[axis] > width)
          return Refusal{i, name_coordinate(axis, x) + " leaves a box wider than " +
                                std::to_string(static_cast<long long>(width))};
      }
    }
    return box;
  }

  bool contains(const Point<D>& p) const {
    for (int axis = 0; axis < D; ++axis)
      if (!(lowest_[axis] <= p[axis] && p[axis] <= highest_[axis] && is_integer(p[axis]))) return false;
    return true;
  }

 private:
  IntegerBox() {
    lowest_.fill(std::numeric_limits<double>::infinity());
    highest_.fill(-std::numeric_limits<double>::infinity());
  }
  static bool is_integer(double x) { return std::trunc(x) == x; }

  std::array<double, D> lowest_, highest_;
};

}  // namespace tribunal
