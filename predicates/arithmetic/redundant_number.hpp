// Knuth's redundant representation with as many digits as it takes: digits are carried only where the next
// product would not fit otherwise, and the type says where that is.
#pragma once

#include "predicates/arithmetic/fixed_integer.hpp"
#include "predicates/sign.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tribunal {

inline constexpr int redundant_digit_bits = 28;

/// The sum of digit_i R^i, R = 2^28, with |digit_i| <= Bound in 64-bit words. Digits overlap, so numbers add
/// digit by digit and multiply by convolution, without a carry; bounds add and multiply along in the types.
template <int Digits, std::uint64_t Bound>
struct RedundantNumber {
  static constexpr int digits = Digits;
  static constexpr std::uint64_t bound = Bound;
  std::array<std::int64_t, Digits> digit{};
};

namespace detail {

inline constexpr std::int64_t redundant_mask = (std::int64_t{1} << redundant_digit_bits) - 1;
/// Leaves room for a carry beside the digit in a signed word.
inline constexpr std::uint64_t redundant_limit = std::uint64_t{1} << 62;

/// At most min(A, B) products of digits meet in one place.
constexpr bool product_fits(int digits_a, std::uint64_t bound_a, int digits_b, std::uint64_t bound_b) {
  const auto products = static_cast<UInt128>(std::min(digits_a, digits_b));
  return bound_a <= redundant_limit / bound_b && products * bound_a * bound_b <= redundant_limit;
}

/// The same number with smaller digits and one more of them: each digit keeps its low 28 bits, which are not
/// negative, and moves the rest, at most Bound / R + 1 in magnitude, to its neighbour. Nothing ripples.
template <int D, std::uint64_t B>
constexpr auto carried(const RedundantNumber<D, B>& a) {
  RedundantNumber<D + 1, (std::uint64_t{1} << redundant_digit_bits) + (B >> redundant_digit_bits)> result;
  for (int i = 0; i < D; ++i) {
    result.digit[i] += a.digit[i] & redundant_mask;
    result.digit[i + 1] = a.digit[i] >> redundant_digit_bits;
  }
  return result;
}

/// a + sign * b, digit by digit.
template <int D1, std::uint64_t B1, int D2, std::uint64_t B2>
constexpr auto combined(const RedundantNumber<D1, B1>& a, const RedundantNumber<D2, B2>& b,
                        std::int64_t sign) {
  if constexpr (B1 + B2 > redundant_limit) {
    return combined(carried(a), carried(b), sign);
  } else {
    RedundantNumber<std::max(D1, D2), B1 + B2> sum;
    for (int i = 0; i < D1; ++i) sum.digit[i] = a.digit[i];
    for (int i = 0; i < D2; ++i) sum.digit[i] += sign * b.digit[i];
    return sum;
  }
}

}  // namespace detail

/// An integer of at most 28 Digits bits.
template <int Digits>
constexpr auto to_redundant(std::int64_t value) {
  RedundantNumber<Digits, std::uint64_t{1} << redundant_digit_bits> number;
  for (int i = 0; i < Digits - 1; ++i, value >>= redundant_digit_bits)
    number.digit[i] = value & detail::redundant_mask;
  number.digit[Digits - 1] = value;
  return number;
}

template <int D1, std::uint64_t B1, int D2, std::uint64_t B2>
constexpr auto operator+(const RedundantNumber<D1, B1>& a, const RedundantNumber<D2, B2>& b) {
  return detail::combined(a, b, 1);
}
template <int D1, std::uint64_t B1, int D2, std::uint64_t B2>
constexpr auto operator-(const RedundantNumber<D1, B1>& a, const RedundantNumber<D2, B2>& b) {
  return detail::combined(a, b, -1);
}

/// The factor with the larger digits is carried until the product fits.
template <int D1, std::uint64_t B1, int D2, std::uint64_t B2>
constexpr auto operator*(const RedundantNumber<D1, B1>& a, const RedundantNumber<D2, B2>& b) {
  if constexpr (detail::product_fits(D1, B1, D2, B2)) {
    constexpr std::uint64_t bound = static_cast<std::uint64_t>(std::min(D1, D2)) * B1 * B2;
    RedundantNumber<D1 + D2 - 1, bound> product;
    for (int i = 0; i < D1; ++i)
      for (int j = 0; j < D2; ++j) product.digit[i + j] += a.digit[i] * b.digit[j];
    return product;
  } else if constexpr (B1 >= B2) {
    return detail::carried(a) * b;
  } else {
    return a * detail::carried(b);
  }
}

/// One carry from the lowest digit to the highest makes all but the highest nonnegative digits below R: it
/// has the sign unless it is zero.
template <int D, std::uint64_t B>
constexpr Sign sign_of(const RedundantNumber<D, B>& a) {
  static_assert(B <= detail::redundant_limit);
  std::int64_t carry = 0, rest = 0;
  for (int i = 0; i < D - 1; ++i) {
    const std::int64_t digit = a.digit[i] + carry;
    rest |= digit & detail::redundant_mask;
    carry = digit >> redundant_digit_bits;
  }
  const std::int64_t highest = a.digit[D - 1] + carry;
  return highest != 0 ? sign_of(highest) : sign_of(rest);
}

}  // namespace tribunal
