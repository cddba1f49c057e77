// A double taken apart: every finite one is an integer times a power of two.
#pragma once

#include <bit>
#include <cstdint>

namespace tribunal {

/// mantissa * 2^exponent, with |mantissa| < 2^53 odd, or 0 * 2^0.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

/// The parts of x, which must be finite. Exact, subnormals included.
constexpr Dyadic to_dyadic(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased_exponent = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t magnitude = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased_exponent != 0) magnitude |= std::uint64_t{1} << 52;
  if (magnitude == 0) return {0, 0};
  const int trailing_zeros = std::countr_zero(magnitude);
  const auto mantissa = static_cast<std::int64_t>(magnitude >> trailing_zeros);
  // A subnormal has the exponent of the smallest normal numbers.
  const int exponent = (biased_exponent == 0 ? 1 : biased_exponent) - 1075 + trailing_zeros;
  return {bits >> 63 != 0 ? -mantissa : mantissa, exponent};
}

/// x / 2^unit, of which x must be a multiple and which Integer must hold.
template <class Integer>
constexpr Integer to_units(double x, int unit) {
  const Dyadic dyadic = to_dyadic(x);
  const int shift = dyadic.mantissa == 0 ? 0 : dyadic.exponent - unit;
  return Integer{dyadic.mantissa} * (Integer{1} << shift);
}

/// 2^exponent as a normal number: exponent in [-1022, 1023].
constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace tribunal
