// Law: a filter never certifies a wrong sign, on any finite doubles.
#include "predicates/filters/double_double.hpp"
#include "predicates/filters/dynamic.hpp"
#include "predicates/working_box.hpp"
#include "tests/laws/kernels.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace tribunal::laws {
namespace {

// The coefficients as they follow from the tables of the derivations, to first order.
constexpr bool is_nearly(double coefficient, double units) {
  return units < coefficient && coefficient < units * (1 + 0x1p-36);
}
static_assert(is_nearly(double_double_coefficient<Orient<2>> * 0x1p106, 11));
static_assert(is_nearly(double_double_coefficient<Orient<3>> * 0x1p106, 25));
static_assert(is_nearly(double_double_coefficient<InSphere<2>> * 0x1p106, 36));
static_assert(is_nearly(double_double_coefficient<InSphere<3>> * 0x1p106, 56));

/// How often each filter decided; a law about one that never does would hold for nothing.
struct Decided {
  int by_box = 0, by_points = 0, by_double_doubles = 0;
};

template <class Formula, int D>
void expect_sound(const Query<Formula>& query, Sign truth, double width, Decided& decided,
                  const Case<D>& points) {
  const auto check = [&](Sign certified, int& count, const char* filter) {
    if (certified == Sign::zero) return;
    ++count;
    EXPECT_EQ(certified, truth) << filter << ": " << hexadecimal<D>(points);
  };
  const double determinant = Formula::determinant(query);
  check(sign_beyond(determinant, error_bound_in_box<Formula>(width)), decided.by_box, "box");
  check(filtered_sign<Formula>(query), decided.by_points, "points");
  check(double_double_sign<Formula>(query), decided.by_double_doubles, "double-double");
  check(tribunal::detail::double_double_sign_here<Formula>(query), decided.by_double_doubles,
        "without instruction");
}

template <int D>
Decided expect_all_sound() {
  Decided decided;
  for (const auto& family : families<D>()) {
    for (const auto& points : family.cases) {
      // Each case has a box of its own: the tightest that the law allows.
      const double width = WorkingBox::around(std::span<const Point<D>>(points)).width();
      Query<Orient<D>> orientation;
      std::copy_n(points.begin(), D + 1, orientation.begin());
      expect_sound<Orient<D>>(orientation, true_orient<D>(points), width, decided, points);
      expect_sound<InSphere<D>>(points, true_in_sphere<D>(points), width, decided, points);
    }
  }
  return decided;
}

template <int D>
void expect_each_finer_than_the_last() {
  const Decided decided = expect_all_sound<D>();
  EXPECT_GT(decided.by_box, 10000);
  EXPECT_GT(decided.by_points, decided.by_box);
  EXPECT_GT(decided.by_double_doubles / 2, decided.by_points + 1000);
}

TEST(Filters, NeverCertifyAWrongSignInThePlane) { expect_each_finer_than_the_last<2>(); }
TEST(Filters, NeverCertifyAWrongSignInSpace) { expect_each_finer_than_the_last<3>(); }

/// A value with the exact one that it stands for.
template <class Value>
struct Tracked {
  Value value;
  mpq_class exact;
};

/// |x' - x| <= c u m, the promise of the derivation.
template <Filterable Value>
void expect_promise(const Tracked<Value>& x, int c) {
  const mpq_class error = abs(mpq_class(x.value.value) - x.exact);
  EXPECT_LE(error, mpq_class(x.value.magnitude()) * mpq_class(c * 0x1p-53 * (1 + 0x1p-40)))
      << x.value.value << " of magnitude " << x.value.magnitude() << ", c = " << c;
}

/// Each operation alone keeps its promise, also where its products underflow.
TEST(Filters, KeepThePromiseOfEveryOperation) {
  Random random(7);
  const auto draw = [&random](int exponent) {
    const double high = std::ldexp(random.unit() - 0.5, exponent),
                 low = std::ldexp(random.unit(), exponent - 3);
    return Tracked<FilteredDifference>{FilteredCoordinate{high} - FilteredCoordinate{low},
                                       mpq_class(high) - mpq_class(low)};
  };
  const auto product = [](const auto& a, const auto& b) {
    const auto value = a.value * b.value;
    return Tracked<decltype(value)>{value, a.exact * b.exact};
  };
  for (const int exponent : {0, -255, -265, -340, -355, -500, -520, -535, -537})
    for (int repeat = 0; repeat < 1000; ++repeat) {
      const auto a = draw(exponent), b = draw(exponent), c = draw(exponent), d = draw(exponent);
      expect_promise(product(a, b), 3);
      const Tracked<FilteredValue> sum{a.value * b.value + c.value * d.value,
                                       a.exact * b.exact + c.exact * d.exact},
          difference{a.value * d.value - b.value * c.value, a.exact * d.exact - b.exact * c.exact};
      expect_promise(sum, 4);
      expect_promise(difference, 4);
      expect_promise(product(draw(-1074 - 2 * exponent), sum), 6);
      expect_promise(product(sum, difference), 9);
      expect_promise(Tracked<FilteredValue>{sum.value + difference.value, sum.exact + difference.exact}, 5);
      expect_promise(Tracked<FilteredValue>{sum.value - difference.value, sum.exact - difference.exact}, 5);
      expect_promise(product(product(a, b), draw(-1074 - 2 * exponent)), 5);
      expect_promise(Tracked<FilteredValue>{a.value + b.value, a.exact + b.exact}, 2);
      expect_promise(Tracked<FilteredValue>{sum.value - (a.value * b.value), sum.exact - a.exact * b.exact},
                     5);
    }
}

/// With and without an FMA instruction, the same bits: the same decisions on every machine.
TEST(DoubleDouble, IsTheSameWithAndWithoutTheInstruction) {
  for (const auto& family : families<2>())
    for (const auto& points : family.cases)
      ASSERT_EQ(double_double_sign<InSphere<2>>(points),
                tribunal::detail::double_double_sign_here<InSphere<2>>(points));
}

/// The difference of two doubles is exact as a pair, whatever their exponents.
TEST(DoubleDouble, DifferencesLoseNothing) {
  for (const auto& family : families<2>())
    for (const auto& points : family.cases)
      for (const auto& p : points) {
        const auto d = DoubleDoubleCoordinate{p[0]} - DoubleDoubleCoordinate{p[1]};
        if (!std::isfinite(d.high) || !std::isfinite(d.low)) continue;
        ASSERT_LE(std::fabs(d.low), 0x1p-53 * std::fabs(d.high));
        ASSERT_EQ(mpq_class(p[0]) - mpq_class(p[1]), mpq_class(d.high) + mpq_class(d.low));
      }
}

TEST(WorkingBox, IsAllOfSpaceWithoutPoints) {
  const auto box = WorkingBox::around(std::span<const Point2>{});
  EXPECT_TRUE(box.contains(Point2{{-0x1.fffffffffffffp1023, 0x1.fffffffffffffp1023}}));
  EXPECT_FALSE(box.contains(Point2{{HUGE_VAL, 0}}));
  EXPECT_FALSE(box.contains(Point2{{0, std::nan("")}}));
}

/// No difference of two points it holds exceeds its width, also where the box itself is rounded.
TEST(WorkingBox, WidthBoundsEveryDifference) {
  const std::vector<std::vector<Point2>> sets{{{{0, 0}}, {{1, 0.5}}},
                                              {{{0x1p53, 0}}, {{0x1p53 + 2, 1}}},
                                              {{{-0x1p1023, 0}}, {{0x1p1023, 0}}},
                                              {{{0x1p-1074, 0}}, {{0, 0}}},
                                              {{{7, 7}}}};
  for (const auto& points : sets) {
    const auto box = WorkingBox::around(std::span<const Point2>(points));
    for (const auto& p : points) EXPECT_TRUE(box.contains(p));
    Point2 low = points[0], high = points[0];
    // As far out as the box allows, found by doubling steps of one ulp.
    for (double step = 0x1p-1074; step < 0x1p1022; step *= 2) {
      const Point2 further{{high[0] + step, high[1]}}, lower{{low[0] - step, low[1]}};
      if (box.contains(further)) high = further;
      if (box.contains(lower)) low = lower;
    }
    EXPECT_LE(high[0] - low[0], box.width());
  }
}

}  // namespace
}  // namespace tribunal::laws
