// What families draw coordinate by coordinate.
#pragma once

#include "datasets/random.hpp"
#include "predicates/point.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace tribunal::queries {

/// Overwrites every coordinate by what `draw` returns, point by point.
template <int D, class Draw>
void each_coordinate(std::span<Point<D>> points, Draw draw) {
  for (Point<D>& p : points)
    for (double& c : p.coordinate) c = draw();
}

inline bool coin(Random& random) { return random.bits() >> 63 != 0; }

/// Uniform on the integers {low, ..., high}, |low| and |high| below 2^53.
inline std::int64_t integer_between(Random& random, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

/// Random sign, mantissa and exponent, all independent; the exponent in [-bits, bits], |bits| <= 1022.
inline double mixed_exponent(Random& random, int bits) {
  const double mantissa = 1 + random.unit();
  const auto exponent = static_cast<int>(integer_between(random, -bits, bits));
  return std::ldexp(coin(random) ? mantissa : -mantissa, exponent);
}

}  // namespace tribunal::queries
