// Laws: the redundant sign test is exact for all factors below 2^29, or 2^61 in 64-bit words, and so are
// redundant numbers of more digits; as printed the test is not, and each misprint has its witness.
#include "datasets/random.hpp"
#include "predicates/arithmetic/redundant_as_printed.hpp"
#include "predicates/arithmetic/redundant_integer.hpp"
#include "predicates/arithmetic/redundant_number.hpp"
#include "tests/laws/kernels.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal::laws {
namespace {

__extension__ using Wide = __int128;

/// Of 61-bit factors, too: the sum has 124 bits.
template <class Word>
Sign true_sign(const Triple<Word>& x, const Triple<Word>& y) {
  Wide sum = 0;
  for (int i = 0; i < 3; ++i) sum += static_cast<Wide>(x[i]) * y[i];
  return static_cast<Sign>((sum > 0) - (sum < 0));
}

struct Factors {
  Triple<std::int32_t> x, y;
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

/// Every combination of extreme factors: the digits come within a few carries of overflowing their words.
template <class Word>
void is_exact_at_the_ends() {
  constexpr int d = RedundantInteger<Word>::digit_bits;
  constexpr Word most = RedundantInteger<Word>::factor_limit - 1;
  constexpr std::array<Word, 8> values{-most, -most + 1, -(Word{1} << d),        -1,
                                       0,     1,         (Word{1} << 2 * d) - 1, most};
  Triple<Word> x{}, y{};
  for (int code = 0; code < 8 * 8 * 8 * 8 * 8 * 8; ++code) {
    for (int i = 0, rest = code; i < 3; ++i, rest /= 64) x[i] = values[rest % 8], y[i] = values[rest / 8 % 8];
    ASSERT_EQ(sign_of_dot_product(x, y), true_sign(x, y));
  }
}
TEST(RedundantInteger, IsExactAtTheEndsOfItsRange) {
  is_exact_at_the_ends<std::int32_t>();
  is_exact_at_the_ends<std::int64_t>();
}

TEST(RedundantInteger, IsExactIn64BitWords) {
  using Factors64 = Triple<std::int64_t>;
  Random random(61);
  const auto draw = [&] {
    const auto magnitude =
        static_cast<std::int64_t>(random.below(std::uint64_t{1} << (1 + random.below(61))));
    return random.below(2) == 0 ? magnitude : -magnitude;
  };
  for (int i = 0; i < 300000; ++i) {
    Factors64 x{draw(), draw(), draw()}, y{draw(), draw(), draw()};
    if (y[2] != 0 && i % 2 == 0) {  // the third product cancels the others but for a remainder
      const Wide quotient = -(static_cast<Wide>(x[0]) * y[0] + static_cast<Wide>(x[1]) * y[1]) / y[2];
      const Wide limit = RedundantInteger<std::int64_t>::factor_limit;
      if (-limit < quotient && quotient < limit) x[2] = static_cast<std::int64_t>(quotient);
    }
    ASSERT_EQ(sign_of_dot_product(x, y), true_sign(x, y));
  }
}

/// Orientation in space is one such sum too: 2x2 minors times differences in z. (Only insphere takes more
/// digits.)
template <class Word>
void orients_tetrahedra() {
  Random random(3);
  constexpr std::uint64_t size = std::uint64_t{1} << RedundantInteger<Word>::digit_bits;
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t range = i % 2 == 0 ? size : 4;
    Case<3> p{};
    for (auto& point : p) point = draw_point<3>([&] { return static_cast<double>(random.below(range)); });
    std::array<Triple<Word>, 3> v{};  // differences from the first
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) v[k][axis] = static_cast<Word>(p[k + 1][axis] - p[0][axis]);
    const auto minor = [&](int k, int l) { return v[k][0] * v[l][1] - v[k][1] * v[l][0]; };
    const Triple<Word> minors{minor(1, 2), minor(2, 0), minor(0, 1)}, heights{v[0][2], v[1][2], v[2][2]};
    ASSERT_EQ(sign_of_dot_product(minors, heights), true_orient<3>(p)) << hexadecimal<3>(p);
  }
}
TEST(RedundantInteger, OrientsTetrahedraAtTheBitsOfThePlane) {
  orients_tetrahedra<std::int32_t>();
  orients_tetrahedra<std::int64_t>();
}

using Integer = boost::multiprecision::cpp_int;

template <int D, std::uint64_t B>
Integer to_oracle(const RedundantNumber<D, B>& a) {
  Integer value = 0;
  for (int i = D - 1; i >= 0; --i) value = (value << redundant_digit_bits) + a.digit[i];
  return value;
}

template <int D, std::uint64_t B>
void keeps_its_bound(const RedundantNumber<D, B>& a) {
  for (const std::int64_t digit : a.digit)
    ASSERT_LE(static_cast<std::uint64_t>(digit < 0 ? -digit : digit), B);
}

/// Sums and products are those of integers, and no digit exceeds what its type says, so that none ever
/// overflows.
TEST(RedundantNumber, IsTheRingOfIntegersWithinItsBounds) {
  Random random(53);
  const auto draw = [&] {
    const std::int64_t extremes[] = {0, 1, (std::int64_t{1} << 53) - 1, std::int64_t{1} << 52, (1 << 28) - 1};
    const auto magnitude = random.below(2) == 0
                               ? extremes[random.below(5)]
                               : static_cast<std::int64_t>(random.below(std::uint64_t{1} << 53));
    return random.below(2) == 0 ? magnitude : -magnitude;
  };
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t a = draw(), b = draw(), c = draw(), d = draw();
    const auto x = to_redundant<2>(a), y = to_redundant<2>(b), z = to_redundant<2>(c), t = to_redundant<2>(d);
    const auto minor = x * y - z * t;
    const auto cubic = minor * z + minor * t;
    const auto quintic = cubic * minor - minor * cubic * to_redundant<1>(3);
    const Integer exact_minor = Integer(a) * b - Integer(c) * d,
                  exact_cubic = exact_minor * c + exact_minor * d;
    const Integer exact_quintic = -2 * exact_cubic * exact_minor;
    ASSERT_EQ(to_oracle(minor), exact_minor);
    ASSERT_EQ(to_oracle(cubic), exact_cubic);
    ASSERT_EQ(to_oracle(quintic), exact_quintic);
    keeps_its_bound(minor);
    keeps_its_bound(cubic);
    keeps_its_bound(quintic);
    ASSERT_EQ(sign_of(quintic), static_cast<Sign>(exact_quintic.sign()));
    ASSERT_EQ(sign_of(x * y - y * x), Sign::zero);
  }
}

/// The text bounds all digits by 2^29 for 28-bit factors; b of two products goes beyond.
TEST(RedundantInteger, MiddleDigitExceedsTheRangeStatedInTheText) {
  RedundantInteger<std::int32_t> sum;
  constexpr std::int32_t largest = (1 << 28) - 1;
  sum.add_product(1, largest, largest);
  sum.add_product(1, largest, largest);
  EXPECT_EQ(sum.b, 1073610756);
  EXPECT_GT(sum.b, 1 << 29);
}

constexpr Triple<std::int32_t> overwriting_x{-1, -1, 1}, overwriting_y{0, 1, 1};
constexpr Triple<std::int32_t> carrying_x{19317, 1444, -18836}, carrying_y{24311, 26904, 14696};

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
