// Laws: an expansion is the exact value, its components do not overlap and are few; an interval holds the
// true value, whatever underflows or overflows.
#include "datasets/random.hpp"
#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/arithmetic/expansion.hpp"
#include "predicates/arithmetic/interval.hpp"
#include "tests/laws/kernels.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace tribunal::laws {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// x * 2^2148: an integer for every finite double, and for the product of two.
Integer scaled(double x, int shift = 2148) {
  const Dyadic parts = to_dyadic(x);
  const Integer mantissa = parts.mantissa;
  return parts.mantissa == 0 ? Integer(0) : Integer(mantissa * (Integer(1) << (parts.exponent + shift)));
}

double draw(Random& random, int lowest, int highest) {
  const auto range = static_cast<std::uint64_t>(highest - lowest + 1);
  const double magnitude = std::ldexp(1 + random.unit(), lowest + static_cast<int>(random.below(range)));
  return random.below(2) == 0 ? magnitude : -magnitude;
}

Integer value(const Expansion& e) {
  Integer sum = 0;
  for (const double c : e.components()) sum += scaled(c);
  return sum;
}

/// In order of magnitude, each a multiple of what bounds all below it.
void is_well_formed(const Expansion& e) {
  const auto c = e.components();
  for (std::size_t i = 0; i < c.size(); ++i) {
    ASSERT_NE(c[i], 0);
    if (i == 0) continue;
    ASSERT_LT(std::ilogb(c[i - 1]) + 1, to_dyadic(c[i]).exponent) << "overlapping or adjacent";
  }
}

TEST(Expansion, IsTheRingOfDyadicNumbers) {
  Random random(19);
  std::size_t longest = 0;
  for (int i = 0; i < 3000; ++i) {
    const int spread = 1 << random.below(8);
    const auto difference = [&] {
      return Expansion::difference(draw(random, -spread, spread), draw(random, -spread, spread));
    };
    const Expansion a = difference(), b = difference(), c = difference(), d = difference();
    const Expansion minor = a * b - c * d, cubic = minor * a + minor * c;
    const Integer unit = scaled(1), exact_minor = (value(a) * value(b) - value(c) * value(d)) / unit,
                  exact_cubic = exact_minor * (value(a) + value(c)) / unit;
    ASSERT_EQ(value(minor), exact_minor);
    ASSERT_EQ(value(cubic), exact_cubic);
    ASSERT_EQ(sign_of(cubic), static_cast<Sign>(exact_cubic.sign()));
    ASSERT_EQ(sign_of(minor * a - a * minor), Sign::zero);
    is_well_formed(minor);
    is_well_formed(cubic);
    longest = std::max(longest, cubic.components().size());
  }
  EXPECT_GT(longest, 10U) << "no long one was met";
  EXPECT_LE(longest, static_cast<std::size_t>(Expansion::most_components));
}

/// Whether the interval holds the integer, scaled like its ends.
bool holds(const Interval& interval, const Integer& exact) {
  return (!std::isfinite(interval.low()) || scaled(interval.low()) <= exact) &&
         (!std::isfinite(interval.high()) || exact <= scaled(interval.high()));
}

TEST(Interval, HoldsTheTrueValue) {
  Random random(20);
  int narrow = 0, infinite = 0;
  for (const auto& [lowest, highest] : {std::pair(-30, 30), std::pair(-1074, 1023), std::pair(-560, -500),
                                        std::pair(-1074, -1000), std::pair(500, 530), std::pair(1010, 1023)})
    for (int i = 0; i < 3000; ++i) {
      const double a = draw(random, lowest, highest), b = draw(random, lowest, highest),
                   c = draw(random, lowest, highest), d = draw(random, lowest, highest);
      const Interval x = Interval(a) - Interval(b), y = Interval(c) - Interval(d);
      const Integer exact_x = scaled(a) - scaled(b), exact_y = scaled(c) - scaled(d);
      ASSERT_TRUE(holds(x, exact_x));
      ASSERT_TRUE(holds(x + y, exact_x + exact_y));
      ASSERT_TRUE(holds(x - y, exact_x - exact_y));
      // (x 2^2148) (y 2^2148) / 2^2148, rounded either way without harm: differences are multiples of
      // 2^-1074.
      ASSERT_TRUE(holds(x * y, exact_x * exact_y / scaled(1)));
      ASSERT_TRUE(holds(x * x - y * y, (exact_x * exact_x - exact_y * exact_y) / scaled(1)));
      narrow += x.low() == x.high();
      infinite += std::isinf((x * y).low());
    }
  EXPECT_GT(narrow, 100) << "exact differences stay single points";
  EXPECT_GT(infinite, 100);
}

TEST(Interval, OfEverythingCertifiesNothing) {
  const double largest = std::numeric_limits<double>::max();
  const Interval everything = Interval(largest) * Interval(largest);
  EXPECT_EQ(certain_sign(everything), std::nullopt);
  EXPECT_EQ(certain_sign(everything * Interval(0)), std::nullopt);
  EXPECT_EQ(certain_sign(everything - everything), std::nullopt);
  EXPECT_EQ(certain_sign(Interval(0x1p-1074) * Interval(0x1p-1074)), std::nullopt);
  EXPECT_EQ(certain_sign(Interval(0.1) - Interval(0.1)), Sign::zero);
  EXPECT_EQ(certain_sign(Interval(0.1) * Interval(-0.3)), Sign::negative);
}

}  // namespace
}  // namespace tribunal::laws
