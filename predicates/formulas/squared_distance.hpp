// The square of a distance: what formulas about lengths are made of.
#pragma once

namespace tribunal {

/// |a - b|^2 in D = 2 or 3 dimensions, over any ring.
template <int D>
constexpr auto squared_distance(const auto& a, const auto& b) {
  const auto x = a[0] - b[0], y = a[1] - b[1];
  if constexpr (D == 2) {
    return x * x + y * y;
  } else {
    const auto z = a[2] - b[2];
    return x * x + y * y + z * z;
  }
}

}  // namespace tribunal
