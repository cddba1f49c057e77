// The one answer a predicate gives. A sign is an enumerator, never a number: it cannot be averaged, scaled or
// compared with a tolerance by accident.
#pragma once

#include <cstdint>

namespace tribunal {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<std::int8_t>(s)); }

constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<std::int8_t>(a) * static_cast<std::int8_t>(b));
}

/// Sign of `value` by exact comparison with zero. A NaN has no sign and compares as zero: callers that can
/// meet one must ask first.
template <class Number>
constexpr Sign sign_of(const Number& value) {
  const Number zero{};
  return static_cast<Sign>((value > zero) - (value < zero));
}

/// '+', '-' or '0', as `tribunal sign` prints it.
constexpr char to_char(Sign s) { return s == Sign::positive ? '+' : s == Sign::negative ? '-' : '0'; }

}  // namespace tribunal
