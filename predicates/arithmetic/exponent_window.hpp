// The powers of two that some doubles are made of.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace tribunal {

/// The narrowest window such that all numbers included are multiples of 2^lowest below 2^highest in
/// magnitude. Zero asks for nothing.
struct ExponentWindow {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();

  constexpr bool empty() const { return lowest > highest; }
  /// How many bits an integer of unit 2^lowest needs: 0 when empty.
  constexpr int bits() const { return empty() ? 0 : highest - lowest; }

  constexpr void include(double x) {
    const Dyadic parts = to_dyadic(x);
    if (parts.mantissa == 0) return;
    const auto magnitude = static_cast<std::uint64_t>(parts.mantissa < 0 ? -parts.mantissa : parts.mantissa);
    lowest = std::min(lowest, parts.exponent);
    highest = std::max(highest, parts.exponent + static_cast<int>(std::bit_width(magnitude)));
  }
};

/// The window of all coordinates of some points. O(n).
constexpr ExponentWindow exponent_window(const auto& points) {
  ExponentWindow window;
  for (const auto& point : points)
    for (const double c : point.coordinate) window.include(c);
  return window;
}

}  // namespace tribunal
