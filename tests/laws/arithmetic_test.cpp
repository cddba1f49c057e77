// Laws: fixed-width integers are the ring of integers as far as their width reaches, a double is its dyadic
// parts, and error bounds bound the errors.
#include "datasets/random.hpp"
#include "predicates/arithmetic/bounded_integer.hpp"
#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/arithmetic/fixed_integer.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/filters/static.hpp"
#include "predicates/sign.hpp"
#include "tests/laws/kernels.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace tribunal::laws {
namespace {

using Integer = boost::multiprecision::cpp_int;

template <std::size_t Words>
Integer to_oracle(const FixedInteger<Words>& a) {
  Integer value = 0;
  for (std::size_t i = Words; i-- > 0;) value = (value << 64) + a.word[i];
  if (a.is_negative()) value -= Integer(1) << (64 * Words);
  return value;
}

/// Random words, often all zeros or all ones: where carries run.
template <std::size_t Words>
FixedInteger<Words> draw(Random& random) {
  FixedInteger<Words> a;
  for (auto& word : a.word) {
    const auto kind = random.below(4);
    word = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random.bits();
  }
  return a;
}

template <std::size_t A, std::size_t B, std::size_t To>
void multiplies_like_integers(Random& random) {
  for (int i = 0; i < 2000; ++i) {
    const auto a = draw<A>(random);
    const auto b = draw<B>(random);
    ASSERT_EQ(to_oracle(multiply<FixedInteger<To>>(a, b)), to_oracle(a) * to_oracle(b));
  }
}

TEST(FixedInteger, MultipliesLikeIntegers) {
  Random random(1);
  multiplies_like_integers<1, 1, 3>(random);
  multiplies_like_integers<2, 1, 3>(random);
  multiplies_like_integers<1, 2, 4>(random);
  multiplies_like_integers<2, 2, 4>(random);
  multiplies_like_integers<3, 2, 5>(random);
  multiplies_like_integers<3, 2, 6>(random);
}

/// A product that fits is right even in fewer words than its factors have together.
TEST(FixedInteger, TruncatesProductsThatFit) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto a = widen<FixedInteger<3>>(static_cast<std::int64_t>(random.bits()));
    const auto b =
        widen<FixedInteger<3>>(static_cast<Int128>(static_cast<std::int64_t>(random.bits())) << 32);
    ASSERT_EQ(to_oracle(multiply<FixedInteger<3>>(a, b)), to_oracle(a) * to_oracle(b));
  }
}

TEST(FixedInteger, AddsSubtractsAndHasASign) {
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const auto a = widen<FixedInteger<4>>(draw<3>(random)), b = widen<FixedInteger<4>>(draw<3>(random));
    ASSERT_EQ(to_oracle(a + b), to_oracle(a) + to_oracle(b));
    ASSERT_EQ(to_oracle(a - b), to_oracle(a) - to_oracle(b));
    ASSERT_EQ(sign_of(a - b), static_cast<Sign>((to_oracle(a) - to_oracle(b)).sign()));
    ASSERT_EQ(sign_of(a - a), Sign::zero);
  }
}

TEST(BoundedInteger, IsStoredJustAsWideAsItsBoundAsks) {
  using Difference = BoundedInteger<28>;
  using Minor = decltype(Difference{} * Difference{} - Difference{} * Difference{});
  static_assert(std::is_same_v<Minor::Storage, std::int64_t> && Minor::magnitude_bits == 57);
  using Product = decltype(Minor{} * Minor{});
  static_assert(std::is_same_v<Product::Storage, Int128> && Product::magnitude_bits == 114);
  static_assert(std::is_same_v<decltype(Product{} * Minor{})::Storage, FixedInteger<3>>);
  EXPECT_EQ(sign_of(Minor{-1} * Minor{std::int64_t{1} << 56}), Sign::negative);
}

TEST(Dyadic, PutsEveryFiniteDoubleTogetherAgain) {
  Random random(4);
  const double limits[] = {
      0.0, -0.0, 1, -3, 0x1p-1074, 0x1.fffffffffffffp-1023, 0x1p-1022, std::numeric_limits<double>::max()};
  for (const double x : limits) {
    const Dyadic parts = to_dyadic(x);
    EXPECT_EQ(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent), x);
  }
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(random.bits());
    if (!std::isfinite(x)) continue;
    const Dyadic parts = to_dyadic(x);
    ASSERT_EQ(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent), x);
    ASSERT_TRUE(x == 0 || parts.mantissa % 2 != 0);
  }
}

TEST(Dyadic, PowersOfTwoAreWhatTheySay) {
  for (int e = -1022; e <= 1023; ++e) ASSERT_EQ(power_of_two(e), std::ldexp(1.0, e));
}

/// The published constants of all four determinants, to two decimals of their logarithm.
TEST(StaticErrorBound, IsAsPublished) {
  const auto logarithm = [](double error) { return std::log2(error); };
  EXPECT_NEAR(logarithm(static_error_bound<Orient<3>>(28)), 35.81, 0.01);
  EXPECT_NEAR(logarithm(static_error_bound<Orient<3>>(53)), 110.81, 0.01);
  EXPECT_NEAR(logarithm(static_error_bound<InSphere<2>>(36)), 97.32, 0.01);
  EXPECT_NEAR(logarithm(static_error_bound<InSphere<3>>(24)), 75.73, 0.01);
  EXPECT_NEAR(logarithm(static_error_bound<InSphere<3>>(53)), 221.57, 0.01);
}

/// Differences of any number of bits get the least width that holds them: none overflows on the way, even
/// where the determinant itself would come out right modulo the width.
TEST(IntegerSign, LadderGivesTheLeastStepThatHolds) {
  const auto step_of = [](int bits) { return visit_ladder(bits, []<int Bits>() { return Bits; }); };
  int below = 0;
  for (const int step : {14, 24, 28, 36, 53}) {
    for (int bits = below + 1; bits <= step; ++bits) EXPECT_EQ(step_of(bits), step) << bits;
    below = step;
  }
}

TEST(StaticErrorBound, ScalesWithTheLatticeUntilTheDeterminantCouldLeaveTheRange) {
  const double unit = static_error_bound<InSphere<2>>(28);
  EXPECT_EQ(static_error_bound<InSphere<2>>(28, 10, 4), unit * 0x1p40);
  EXPECT_EQ(static_error_bound<InSphere<2>>(28, -255, 4), unit * 0x1p-1020);
  EXPECT_EQ(static_error_bound<InSphere<2>>(28, -256, 4), std::numeric_limits<double>::infinity());
  EXPECT_LT(static_error_bound<InSphere<2>>(28, 226, 4), std::numeric_limits<double>::infinity());
  EXPECT_EQ(static_error_bound<InSphere<2>>(28, 227, 4), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tribunal::laws
