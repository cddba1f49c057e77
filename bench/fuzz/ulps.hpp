// Steps from double to double.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace tribunal::bench::fuzz {

/// The finite double `steps` places after x in their order (before it, where negative), -0 and +0 being one
/// place; the largest or smallest finite double where there are not so many more.
inline double moved_by_ulps(double x, int steps) {
  constexpr auto largest = std::bit_cast<std::int64_t>(std::numeric_limits<double>::max());
  // Magnitudes of one sign are ordered as their bits are: on both sides of zero, places are signed integers.
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto magnitude = static_cast<std::int64_t>(bits << 1 >> 1);
  const std::int64_t place = bits >> 63 != 0 ? -magnitude : magnitude;
  const std::int64_t moved = std::clamp(place + steps, -largest, largest);
  return moved < 0 ? -std::bit_cast<double>(-moved) : std::bit_cast<double>(moved);
}

/// The finite double nearest to x; 0 for NaN.
inline double made_finite(double x) {
  constexpr double largest = std::numeric_limits<double>::max();
  return x != x ? 0.0 : std::clamp(x, -largest, largest);
}

}  // namespace tribunal::bench::fuzz
