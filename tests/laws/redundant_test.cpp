// Laws: the redundant sign test is exact for all factors below 2^29; as printed it is not, and each misprint
// has its witness.
#include "datasets/random.hpp"
#include "predicates/arithmetic/redundant_as_printed.hpp"
#include "predicates/arithmetic/redundant_integer.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal::laws {
namespace {

__extension__ using Wide = __int128;

Sign true_sign(const Triple& x, const Triple& y) {
  Wide sum = 0;
  for (int i = 0; i < 3; ++i) sum += static_cast<Wide>(x[i]) * y[i];
  return static_cast<Sign>((sum > 0) - (sum < 0));
}

struct Factors {
  Triple x, y;
};

/// Signed x and y >= 0 below 2^bits.
Factors draw_uniform(Random& random, int bits) {
  Factors f{};
  for (int i = 0; i < 3; ++i) {
    f.x[i] = static_cast<std::int32_t>(random.below(std::uint64_t{1} << bits));
    if (random.below(2) == 0) f.x[i] = -f.x[i];
    f.y[i] = static_cast<std::int32_t>(random.below(std::uint64_t{1} << bits));
  }
  return f;
}

/// The third product cancels the others but for a remainder below its y, where the quotient is small enough.
Factors draw_cancelling(Random& random) {
  Factors f = draw_uniform(random, 28);
  if (f.y[2] == 0) return f;
  const std::int64_t others = std::int64_t{f.x[0]} * f.y[0] + std::int64_t{f.x[1]} * f.y[1];
  const std::int64_t quotient = -others / f.y[2];
  if (-(1 << 29) < quotient && quotient < 1 << 29) f.x[2] = static_cast<std::int32_t>(quotient);
  return f;
}

int count_wrong(int cases, auto draw, Misprints misprints) {
  Random random(29);
  int wrong = 0;
  for (int i = 0; i < cases; ++i) {
    const Factors f = draw(random);
    wrong += sign_of_dot_product_as_printed(f.x, f.y, misprints) != true_sign(f.x, f.y);
  }
  return wrong;
}
const auto uniform = [](Random& random) { return draw_uniform(random, 28); };

TEST(RedundantInteger, IsExactOnUniformAndOnCancellingFactors) {
  Random random(28);
  for (int i = 0; i < 300000; ++i)
    for (const Factors& f : {draw_uniform(random, 29), draw_uniform(random, 3), draw_cancelling(random)})
      ASSERT_EQ(sign_of_dot_product(f.x, f.y), true_sign(f.x, f.y))
          << f.x[0] << " " << f.x[1] << " " << f.x[2] << ", " << f.y[0] << " " << f.y[1] << " " << f.y[2];
}

/// Every combination of extreme factors: the digits come within 2^17 of overflowing 32 bits.
TEST(RedundantInteger, IsExactAtTheEndsOfItsRange) {
  constexpr std::int32_t most = (1 << 29) - 1;
  constexpr std::array<std::int32_t, 8> values{-most, -most + 1, -(1 << 14), -1, 0, 1, (1 << 28) - 1, most};
  Triple x{}, y{};
  for (int code = 0; code < 8 * 8 * 8 * 8 * 8 * 8; ++code) {
    for (int i = 0, rest = code; i < 3; ++i, rest /= 64) x[i] = values[rest % 8], y[i] = values[rest / 8 % 8];
    ASSERT_EQ(sign_of_dot_product(x, y), true_sign(x, y));
  }
}

/// The text bounds all digits by 2^29 for 28-bit factors; b of two products goes beyond.
TEST(RedundantInteger, MiddleDigitExceedsTheRangeStatedInTheText) {
  RedundantInteger sum;
  constexpr std::int32_t largest = (1 << 28) - 1;
  sum.add_product(1, largest, largest);
  sum.add_product(1, largest, largest);
  EXPECT_EQ(sum.b, 1073610756);
  EXPECT_GT(sum.b, 1 << 29);
}

constexpr Triple overwriting_x{-1, -1, 1}, overwriting_y{0, 1, 1};
constexpr Triple carrying_x{19317, 1444, -18836}, carrying_y{24311, 26904, 14696};

TEST(PrintedProgram, OverwritingTheSumsGivesAZeroASign) {
  EXPECT_EQ(true_sign(overwriting_x, overwriting_y), Sign::zero);
  EXPECT_EQ(sign_of_dot_product(overwriting_x, overwriting_y), Sign::zero);
  EXPECT_EQ(sign_of_dot_product_as_printed(overwriting_x, overwriting_y), Sign::negative);
  EXPECT_EQ(sign_of_dot_product_as_printed(overwriting_x, overwriting_y, {.third_product_overwrites = false}),
            Sign::zero);
}

/// This misprint shows once the first is corrected: the exact value is +231651107.
TEST(PrintedProgram, OverwritingTheCarryInvertsASign) {
  EXPECT_EQ(true_sign(carrying_x, carrying_y), Sign::positive);
  EXPECT_EQ(sign_of_dot_product(carrying_x, carrying_y), Sign::positive);
  const Misprints carry_alone{
      .third_product_overwrites = false, .carry_overwrites = true, .late_exits = false};
  EXPECT_EQ(sign_of_dot_product_as_printed(carrying_x, carrying_y, carry_alone), Sign::negative);
}

TEST(PrintedProgram, FatalMisprintsFailAtTheirRates) {
  constexpr int cases = 200000;
  EXPECT_NEAR(count_wrong(cases, uniform, as_printed), 0.188 * cases, 0.005 * cases);
  EXPECT_GT(count_wrong(cases, draw_cancelling, {.third_product_overwrites = false}), cases / 4);
}

TEST(PrintedProgram, CorrectedThroughoutItIsExact) {
  EXPECT_EQ(count_wrong(200000, uniform, all_corrected), 0);
  EXPECT_EQ(count_wrong(200000, draw_cancelling, all_corrected), 0);
}

TEST(PrintedProgram, ItsLateExitsDoNoHarm) {
  const Misprints late_alone{
      .third_product_overwrites = false, .carry_overwrites = false, .late_exits = true};
  EXPECT_EQ(count_wrong(200000, uniform, late_alone), 0);
  EXPECT_EQ(count_wrong(200000, draw_cancelling, late_alone), 0);
}

}  // namespace
}  // namespace tribunal::laws
