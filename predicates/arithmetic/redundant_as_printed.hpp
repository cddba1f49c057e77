// The redundant sign test as Barth prints it, misprints included: an exhibit.
#pragma once

#include "predicates/arithmetic/redundant_integer.hpp"
#include "predicates/sign.hpp"

#include <cstdint>
#include <utility>

namespace tribunal {

/// Where the program printed in Barth's section 3.7 differs from the one in Knuth's Stanford GraphBase
/// (gb_plane, sections 15 to 19) that it renders; each can be corrected alone.
struct Misprints {
  /// The third product overwrites a, b and c instead of being subtracted. Fatal: 19 % of random 28-bit cases.
  bool third_product_overwrites = true;
  /// `a = b/#4000` where `a -= b/#4000` is meant. Fatal, but rarely met.
  bool carry_overwrites = true;
  /// `a < -2` for `a <= -2`, and `b > #8000` for `b >= #8000`. Harmless: the exact expression that follows
  /// agrees.
  bool late_exits = true;
};
inline constexpr Misprints as_printed{};
inline constexpr Misprints all_corrected{false, false, false};

/// The sign of x0 y0 + x1 y1 + x2 y2 as the printed program finds it; |x_i| < 2^29, 0 <= y_i < 2^29.
///
/// Two slips that no compiler would accept are read as meant (`rx*rv` for rx*ry, `1x` for lx), a stray
/// semicolon in `while(c<0){;` does nothing, and the reordering, which the text leaves out and describes with
/// impossible signs (s1 = s2 >= 0, s3 < 0), is Knuth's: the third product gets the sign opposite to that of
/// the first two together. The 64-bit words keep the transcription free of overflow; where Knuth's program is
/// correct, 32 bits suffice.
constexpr Sign sign_of_dot_product_as_printed(Triple<std::int32_t> x, const Triple<std::int32_t>& y_given,
                                              Misprints misprints = as_printed) {
  Triple<std::int32_t> y = y_given;
  Triple<std::int32_t> s{};
  for (int i = 0; i < 3; ++i) {
    s[i] = x[i] == 0 || y[i] == 0 ? 0 : x[i] > 0 ? 1 : -1;
    if (x[i] < 0) x[i] = -x[i];
  }
  if ((s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0))
    return sign_of(s[0] + s[1] + s[2]);
  if (s[2] == 0 || s[2] == s[0] || s[2] == s[1]) {
    const int other = s[2] == s[1] ? 0 : 1;
    std::swap(s[2], s[other]);
    std::swap(x[2], x[other]);
    std::swap(y[2], y[other]);
  }

  constexpr std::int64_t radix = 0x4000;
  std::int64_t a = 0, b = 0, c = 0;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t lx = x[i] / radix, rx = x[i] % radix, ly = y[i] / radix, ry = y[i] % radix;
    if (i == 2 && misprints.third_product_overwrites) {
      a = lx * ly, b = lx * ry + ly * rx, c = rx * ry;
    } else {
      const int sign = i == 2 ? -1 : 1;
      a += sign * lx * ly, b += sign * (lx * ry + ly * rx), c += sign * rx * ry;
    }
  }
  std::int64_t s3 = s[2];

  if (a < 0) a = -a, b = -b, c = -c, s3 = -s3;
  while (a != 0 && c < 0) a -= 1, c += 0x10000000;
  if (a == 0) {
    if (misprints.late_exits ? b > 0x8000 : b >= 0x8000) return sign_of(-s3);
    if (b <= -0x8000) return sign_of(s3);
    return sign_of(-s3 * (b * radix + c));
  }
  if (b >= 0) return sign_of(-s3);
  b = -b;
  a = misprints.carry_overwrites ? b / radix : a - b / radix;
  if (a > 0) return sign_of(-s3);
  if (misprints.late_exits ? a < -2 : a <= -2) return sign_of(s3);
  return sign_of(-s3 * ((a * radix - b % radix) * radix + c));
}

static_assert(sign_of_dot_product_as_printed({-1, -1, 1}, {0, 1, 1}) == Sign::negative);

}  // namespace tribunal
