// Laws: both predicates alternate in all their arguments, and know neither where the points lie, nor the unit
// of length, and of mirrors only the orientation.
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tribunal::laws {
namespace {

/// Whether the laws are promised: to exact backends always, to rounded ones where nothing is rounded. The
/// printed program keeps none even there, and single precision rounds some of what double precision does not.
template <int D>
bool is_promised(const BackendEntry& entry, const Family<D>& family) {
  const auto name = entry.about->name;
  return entry.about->exact || (family.exact_in_double && name != "knuth-as-printed" && name != "float");
}

/// Calls check(order, parity) for all permutations of N indices.
template <std::size_t N, class Check>
void for_each_permutation(Check check) {
  std::array<std::size_t, N> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i];
    check(order, inversions % 2 == 0 ? Sign::positive : Sign::negative);
  } while (std::next_permutation(order.begin(), order.end()));
}

class Symmetry : public EveryBackend {
 protected:
  /// Runs check(points, kernel) on cases of all families that the backend accepts and owes the laws on.
  template <int D, class Check>
  void for_each_case(Check check) const {
    for (auto& family : families<D>()) {
      if (!is_promised(entry(), family)) continue;
      family.cases.resize(std::min<std::size_t>(family.cases.size(), D == 2 ? 200 : 40));
      const auto kernel = bind<D>(entry(), family.points());
      if (!kernel) continue;
      SCOPED_TRACE(family.name);
      for (const auto& points : family.cases) check(points, *kernel);
    }
  }

  /// Orientation under all permutations of D + 1 points, in-sphere under all of D + 2: 3!, 4! and 4!, 5!.
  template <int D>
  void is_alternating() const {
    for_each_case<D>([](const Case<D>& points, const Kernel<D>& kernel) {
      const Sign orientation = orient(kernel, points), position = in_sphere(kernel, points);
      Case<D> permuted = points;
      for_each_permutation<D + 1>([&](const auto& order, Sign parity) {
        for (std::size_t i = 0; i < order.size(); ++i) permuted[i] = points[order[i]];
        ASSERT_EQ(orient(kernel, permuted), parity * orientation) << hexadecimal<D>(permuted);
      });
      for_each_permutation<D + 2>([&](const auto& order, Sign parity) {
        for (std::size_t i = 0; i < order.size(); ++i) permuted[i] = points[order[i]];
        ASSERT_EQ(in_sphere(kernel, permuted), parity * position) << hexadecimal<D>(permuted);
      });
    });
  }

  /// A map of space, exact on integers of 13 bits, multiplies both predicates by `factor`.
  template <int D>
  void multiplies_signs(Sign factor, auto map) const {
    Random random(7 + D);
    for (const Family<D>& family :
         {Family<D>{"grid", integer_cases<D>(400, 4, 1, 0, random), true},
          Family<D>{"8 bits", integer_cases<D>(400, 1 << 8, 1, 0, random), true},
          Family<D>{"13 bits", integer_cases<D>(400, 1 << 13, 1, 0, random), false},
          Family<D>{"cospherical", cospherical_cases<D>(400, D == 2 ? 1105 * 1105 : 441, random), false}}) {
      if (!is_promised(entry(), family)) continue;
      SCOPED_TRACE(family.name);
      Family<D> image = family;
      for (auto& points : image.cases) std::transform(points.begin(), points.end(), points.begin(), map);
      const auto kernel = bind<D>(entry(), family.points()), mapped = bind<D>(entry(), image.points());
      ASSERT_TRUE(kernel && mapped);
      for (std::size_t i = 0; i < family.cases.size(); ++i) {
        const Case<D>&before = family.cases[i], &after = image.cases[i];
        ASSERT_EQ(orient(*mapped, after), factor * orient(*kernel, before)) << hexadecimal<D>(before);
        ASSERT_EQ(in_sphere(*mapped, after), factor * in_sphere(*kernel, before)) << hexadecimal<D>(before);
      }
    }
  }
};

TEST_P(Symmetry, AlternatesInThePlane) { is_alternating<2>(); }

TEST_P(Symmetry, AlternatesInSpace) {
  if (entry().bind3 != nullptr) is_alternating<3>();
}

TEST_P(Symmetry, CyclicShiftsOfATripleKeepTheSign) {
  for_each_case<2>([](const Case<2>& points, const Kernel2& kernel) {
    const auto& [a, b, c, d] = points;
    ASSERT_EQ(kernel.orient2d(a, b, c), kernel.orient2d(b, c, a));
    ASSERT_EQ(kernel.orient2d(a, b, c), kernel.orient2d(c, a, b));
    ASSERT_EQ(kernel.incircle(a, b, c, d), kernel.incircle(b, c, a, d));
  });
}

TEST_P(Symmetry, RepeatedPointsGiveZero) {
  for_each_case<2>([](const Case<2>& points, const Kernel2& kernel) {
    const auto& [a, b, c, d] = points;
    ASSERT_EQ(kernel.orient2d(a, b, b), Sign::zero);
    ASSERT_EQ(kernel.orient2d(a, b, a), Sign::zero);
    ASSERT_EQ(kernel.incircle(a, b, c, a), Sign::zero);
    ASSERT_EQ(kernel.incircle(a, b, b, d), Sign::zero);
  });
}

TEST_P(Symmetry, TranslationKeepsTheSign) {
  for (const double amount : {-4095.0, 16384.0, 0x1p39 + 1}) {
    multiplies_signs<2>(Sign::positive, [=](const Point2& p) {
      return Point2{{p[0] + amount, p[1] - amount}};
    });
    if (entry().bind3 == nullptr) continue;
    multiplies_signs<3>(Sign::positive, [=](const Point3& p) {
      return Point3{{p[0] + amount, p[1], p[2] - 2 * amount}};
    });
  }
}

TEST_P(Symmetry, ReflectionReversesTheSign) {
  multiplies_signs<2>(Sign::negative, [](const Point2& p) { return Point2{{p[1], p[0]}}; });
  multiplies_signs<2>(Sign::negative, [](const Point2& p) { return Point2{{-p[0], p[1]}}; });
  if (entry().bind3 == nullptr) return;
  multiplies_signs<3>(Sign::negative, [](const Point3& p) { return Point3{{p[0], p[1], -p[2]}}; });
}

TEST_P(Symmetry, PointReflectionIsARotationInThePlaneOnly) {
  multiplies_signs<2>(Sign::positive, [](const Point2& p) { return Point2{{-p[0], -p[1]}}; });
  if (entry().bind3 == nullptr) return;
  multiplies_signs<3>(Sign::negative, [](const Point3& p) { return Point3{{-p[0], -p[1], -p[2]}}; });
}

TEST_P(Symmetry, DoublingTheUnitKeepsTheSign) {
  multiplies_signs<2>(Sign::positive, [](const Point2& p) { return Point2{{2 * p[0], 2 * p[1]}}; });
  if (entry().bind3 == nullptr) return;
  multiplies_signs<3>(Sign::positive, [](const Point3& p) { return Point3{{2 * p[0], 2 * p[1], 2 * p[2]}}; });
}

TRIBUNAL_FOR_EVERY_BACKEND(Symmetry);

}  // namespace
}  // namespace tribunal::laws
