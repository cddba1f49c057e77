// Products summed in words that are hardly wider than the factors: Knuth's redundant representation.
#pragma once

#include "predicates/sign.hpp"

#include <array>
#include <cassert>
#include <concepts>
#include <cstdint>
#include <limits>

namespace tribunal {

/// a R^2 + b R + c for the radix R = 2^d, where digits are not confined to d bits, so that products are added
/// without carrying. A word has 2d + 4 bits: d is 14 in 32 of them, as in Knuth's Stanford GraphBase, and 30
/// in 64.
template <std::signed_integral Word>
struct RedundantInteger {
  Word a = 0, b = 0, c = 0;

  static constexpr int digit_bits = std::numeric_limits<Word>::digits / 2 - 1;
  static constexpr Word digit_mask = (Word{1} << digit_bits) - 1;
  /// Factors are below this in magnitude: 2^29 or 2^61.
  static constexpr Word factor_limit = Word{1} << (2 * digit_bits + 1);

  /// Adds sign * x * y, for 0 <= x, y < 2^(2d+1). The high halves are below 2^(d+1) and the low ones below
  /// 2^d, so one product contributes less than 2^(2d+2) to a and to b, and less than 2^2d to c.
  constexpr void add_product(Word sign, Word x, Word y) {
    const Word left_x = x >> digit_bits, right_x = x & digit_mask;
    const Word left_y = y >> digit_bits, right_y = y & digit_mask;
    a += sign * (left_x * left_y);
    b += sign * (left_x * right_y + right_x * left_y);
    c += sign * (right_x * right_y);
  }
};

/// Exact for sums of products among which at most two are of either sign: then |a|, |b| < 2^(2d+3) - 2^(d+2)
/// and |c| < 2^(2d+1). Carrying c into b adds less than 2^(d+1). Carrying b makes a the sum divided by R^2,
/// rounded down, and the sum is less than 2 * 2^(4d+2) in magnitude: 2d + 4 bits hold it. What remains of b
/// and c is not negative.
template <class Word>
constexpr Sign sign_of(const RedundantInteger<Word>& sum) {
  using Integer = RedundantInteger<Word>;
  const Word b = sum.b + (sum.c >> Integer::digit_bits);
  const Word a = sum.a + (b >> Integer::digit_bits);
  if (a != 0) return a < 0 ? Sign::negative : Sign::positive;
  const bool rest = (b & Integer::digit_mask) != 0 || (sum.c & Integer::digit_mask) != 0;
  return rest ? Sign::positive : Sign::zero;
}

template <class Word>
using Triple = std::array<Word, 3>;

/// The sign of x0 y0 + x1 y1 + x2 y2 in single words, exactly; |x_i|, |y_i| < 2^29 in 32-bit words, < 2^61 in
/// 64-bit ones. After the sign test of Knuth's Stanford GraphBase (gb_plane, 1993), with one normalising
/// carry in the place of its case analysis. (Barth's section 3.7 bounds the digits by 2^29 already for 28-bit
/// factors; two products reach 2^30 in b.)
template <class Word>
constexpr Sign sign_of_dot_product(const Triple<Word>& x, const Triple<Word>& y) {
  using Integer = RedundantInteger<Word>;
  std::array<Word, 3> sign{};
  int positive = 0, negative = 0;
  for (int i = 0; i < 3; ++i) {
    assert(-Integer::factor_limit < x[i] && x[i] < Integer::factor_limit);
    assert(-Integer::factor_limit < y[i] && y[i] < Integer::factor_limit);
    sign[i] = ((x[i] > 0) - (x[i] < 0)) * ((y[i] > 0) - (y[i] < 0));
    positive += sign[i] > 0;
    negative += sign[i] < 0;
  }
  if (negative == 0) return positive > 0 ? Sign::positive : Sign::zero;
  if (positive == 0) return Sign::negative;
  Integer sum;
  for (int i = 0; i < 3; ++i) sum.add_product(sign[i], x[i] < 0 ? -x[i] : x[i], y[i] < 0 ? -y[i] : y[i]);
  return sign_of(sum);
}

static_assert(RedundantInteger<std::int32_t>::digit_bits == 14 &&
              RedundantInteger<std::int64_t>::digit_bits == 30);
static_assert(sign_of_dot_product<std::int32_t>({-1, -1, 1}, {0, 1, 1}) == Sign::zero);
static_assert(sign_of_dot_product<std::int32_t>({19317, 1444, -18836}, {24311, 26904, 14696}) ==
              Sign::positive);

}  // namespace tribunal
