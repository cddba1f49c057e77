// Products of 29-bit integers summed in 32-bit words: Knuth's redundant representation, and it as Barth
// prints it.
#pragma once

#include "predicates/sign.hpp"

#include <array>
#include <cassert>
#include <cstdint>

namespace tribunal {

/// a 2^28 + b 2^14 + c, where digits are not confined to 14 bits, so that products are added without
/// carrying.
struct RedundantInteger {
  std::int32_t a = 0, b = 0, c = 0;

  static constexpr int digit_bits = 14;
  static constexpr std::int32_t digit_mask = (1 << digit_bits) - 1;

  /// Adds sign * x * y, for 0 <= x, y < 2^29. The high halves are below 2^15 and the low ones below 2^14, so
  /// one product contributes less than 2^30 to a and to b, and less than 2^28 to c.
  constexpr void add_product(std::int32_t sign, std::int32_t x, std::int32_t y) {
    const std::int32_t left_x = x >> digit_bits, right_x = x & digit_mask;
    const std::int32_t left_y = y >> digit_bits, right_y = y & digit_mask;
    a += sign * (left_x * left_y);
    b += sign * (left_x * right_y + right_x * left_y);
    c += sign * (right_x * right_y);
  }
};

/// Exact for sums of products among which at most two are of either sign: then |a|, |b| < 2^31 - 2^16 and |c|
/// < 2^29. Carrying c into b adds less than 2^15. Carrying b makes a the sum divided by 2^28, rounded down,
/// and the sum is less than 2 * 2^58 in magnitude: 32 bits hold it. What remains of b and c is not negative.
constexpr Sign sign_of(const RedundantInteger& sum) {
  const std::int32_t b = sum.b + (sum.c >> RedundantInteger::digit_bits);
  const std::int32_t a = sum.a + (b >> RedundantInteger::digit_bits);
  if (a != 0) return a < 0 ? Sign::negative : Sign::positive;
  const bool rest = (b & RedundantInteger::digit_mask) != 0 || (sum.c & RedundantInteger::digit_mask) != 0;
  return rest ? Sign::positive : Sign::zero;
}

/// Three numbers below 2^29 in magnitude.
using Triple = std::array<std::int32_t, 3>;

/// The sign of x0 y0 + x1 y1 + x2 y2 in 32-bit words, exactly; |x_i|, |y_i| < 2^29. After the sign test of
/// Knuth's Stanford GraphBase (gb_plane, 1993), with one normalising carry in the place of its case analysis.
/// (Barth's section 3.7 bounds the digits by 2^29 already for 28-bit factors; two products reach 2^30 in b.)
constexpr Sign sign_of_dot_product(const Triple& x, const Triple& y) {
  std::array<std::int32_t, 3> sign{};
  int positive = 0, negative = 0;
  for (int i = 0; i < 3; ++i) {
    assert(-(1 << 29) < x[i] && x[i] < 1 << 29 && -(1 << 29) < y[i] && y[i] < 1 << 29);
    sign[i] = ((x[i] > 0) - (x[i] < 0)) * ((y[i] > 0) - (y[i] < 0));
    positive += sign[i] > 0;
    negative += sign[i] < 0;
  }
  if (negative == 0) return positive > 0 ? Sign::positive : Sign::zero;
  if (positive == 0) return Sign::negative;
  RedundantInteger sum;
  for (int i = 0; i < 3; ++i) sum.add_product(sign[i], x[i] < 0 ? -x[i] : x[i], y[i] < 0 ? -y[i] : y[i]);
  return sign_of(sum);
}

static_assert(sign_of_dot_product({-1, -1, 1}, {0, 1, 1}) == Sign::zero);
static_assert(sign_of_dot_product({19317, 1444, -18836}, {24311, 26904, 14696}) == Sign::positive);

}  // namespace tribunal
