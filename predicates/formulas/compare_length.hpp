// Which of two segments is longer.
#pragma once

#include "predicates/formulas/squared_distance.hpp"

namespace tribunal {

/// CompareLength<D>::determinant(p) = |p0 p1|^2 - |p2 p3|^2: positive when the first segment is longer. Over
/// any ring, as Orient<D>; without a square root, which is monotone.
template <int D>
struct CompareLength {
  static constexpr int dimension = D, points = 4;
  static constexpr auto determinant(const auto& p) {
    return squared_distance<D>(p[0], p[1]) - squared_distance<D>(p[2], p[3]);
  }
};

}  // namespace tribunal
