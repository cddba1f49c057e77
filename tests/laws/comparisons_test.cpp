// Laws: every kernel compares lengths and angles; an exact backend's comparisons are true everywhere, an
// inexact one's are its own arithmetic's.
#include "predicates/counted.hpp"
#include "tests/laws/backend_types.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tribunal::laws {
namespace {

class Comparisons : public EveryBackend {};

/// The two angles of a case: at its second point and at its third.
struct Angles {
  Angle<2> p, q;
};
Angles angles_of(const Case<2>& c) { return {{c[0], c[1], c[2]}, {c[3], c[2], c[0]}}; }
bool have_legs(const Angles& a) {
  return !(a.p[0] == a.p[1]) && !(a.p[2] == a.p[1]) && !(a.q[0] == a.q[1]) && !(a.q[2] == a.q[1]);
}

/// Of every family in the backend's domain, degenerate, near-degenerate and out of a double's reach alike.
TEST_P(Comparisons, AreTrueWhereTheBackendIsExact) {
  if (!exact()) return;
  int lengths = 0, angles = 0;
  for (const Family<2>& family : families<2>()) {
    const auto kernel = bind<2>(entry(), family.points());
    if (!kernel) continue;
    SCOPED_TRACE(family.name);
    for (const Case<2>& c : family.cases) {
      ++lengths;
      ASSERT_EQ(kernel->compare_length(c[0], c[1], c[2], c[3]),
                oracle::compare_length(c[0], c[1], c[2], c[3]))
          << hexadecimal<2>(c);
      const Angles a = angles_of(c);
      if (!have_legs(a)) continue;
      ++angles;
      ASSERT_EQ(kernel->compare_angle(a.p, a.q), oracle::compare_angle(a.p, a.q)) << hexadecimal<2>(c);
    }
  }
  EXPECT_GT(lengths, 7000);
  EXPECT_GT(angles, 5000);
}

/// Exchanged arguments, exchanged sign; a segment read backwards and an angle with its legs exchanged are
/// the same.
TEST_P(Comparisons, AreAntisymmetric) {
  const auto family = shared_domain<2>(500, 21);
  const auto kernel = bind<2>(entry(), family.points());
  for (const Case<2>& c : family.cases) {
    const Sign longer = kernel->compare_length(c[0], c[1], c[2], c[3]);
    EXPECT_EQ(kernel->compare_length(c[2], c[3], c[0], c[1]), -longer);
    const auto [p, q] = angles_of(c);
    if (!exact() || !have_legs({p, q})) continue;
    EXPECT_EQ(kernel->compare_length(c[1], c[0], c[2], c[3]), longer);
    const Sign larger = kernel->compare_angle(p, q);
    EXPECT_EQ(kernel->compare_angle(q, p), -larger);
    EXPECT_EQ(kernel->compare_angle({p[2], p[1], p[0]}, q), larger);
    EXPECT_EQ(kernel->compare_angle(p, p), Sign::zero);
  }
}

TRIBUNAL_FOR_EVERY_BACKEND(Comparisons);

/// Equal lengths and angles stay equal where circle ties are broken.
TEST(ComparisonsOf, ASymbolicBackendAreThoseOfTheOneBelow) {
  const std::vector<Point2> square{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
  const auto kernel = bind<2>(*find_backend("filtered+sos"), square);
  EXPECT_NE(kernel->incircle(square[0], square[1], square[2], square[3]), Sign::zero);
  EXPECT_EQ(kernel->compare_length(square[0], square[1], square[2], square[3]), Sign::zero);
  EXPECT_EQ(kernel->compare_angle({square[0], square[1], square[2]}, {square[1], square[2], square[3]}),
            Sign::zero);
}

/// |(1, e)|^2 = 1 + e^2 is 1 in doubles; the angle between (1, 0) and (1, e) beside its exact double.
TEST(ComparisonsOf, AnInexactBackendAreItsOwn) {
  const double e = 0x1p-30;
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{1, e}}};
  const auto naive = bind<2>(*find_backend("double"), points), exact = bind<2>(*find_backend("gmp"), points);
  EXPECT_EQ(naive->compare_length(points[0], points[2], points[0], points[1]), Sign::zero);
  EXPECT_EQ(exact->compare_length(points[0], points[2], points[0], points[1]), Sign::positive);
  EXPECT_EQ(naive->decide_compare_length(points[0], points[2], points[0], points[1]).stage, Stage::rounded);
  const Angle<2> slim{points[1], points[0], points[2]},
      slimmer{points[1], points[0], {{1, std::nextafter(e, 0)}}}, shifted{points[1], points[0], {{1, 2 * e}}};
  EXPECT_EQ(naive->compare_angle(slim, slimmer), exact->compare_angle(slim, slimmer));
  EXPECT_EQ(naive->decide_compare_angle(slim, shifted).stage, Stage::rounded);
}

/// A single word's three products do not hold four lengths; the kernel asks others, exactly.
TEST(ComparisonsOf, KnuthAreCertified) {
  const double side = 16383;
  const std::vector<Point2> square{{{0, 0}}, {{side, 0}}, {{side, side}}, {{0, side}}};
  for (const auto* name : {"knuth", "knuth64"}) {
    const auto kernel = bind<2>(*find_backend(name), square);
    const Decision tie = kernel->decide_compare_length(square[0], square[1], square[2], square[3]);
    EXPECT_EQ(tie.sign, Sign::zero);
    EXPECT_EQ(tie.stage, Stage::integer);
    EXPECT_EQ(kernel->decide_compare_length(square[0], square[2], square[0], square[1]).stage, Stage::filter);
  }
}

TEST(ComparisonsOf, AKernelAreCounted) {
  const std::vector<Point2> square{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
  const auto kernel = bind<2>(*find_backend("filtered"), square);
  PredicateCounts counts;
  const CountedKernel2 counted(*kernel, counts);
  counted.compare_length(square[0], square[1], square[2], square[3]);
  counted.compare_length(square[0], square[2], square[2], square[3]);
  counted.compare_angle({square[0], square[1], square[2]}, {square[1], square[2], square[3]});
  EXPECT_EQ(counts.total(Comparison::length), 2u);
  EXPECT_EQ(counts.total(Comparison::angle), 1u);
  EXPECT_EQ(counts.total(), 3u);
  const std::vector<std::pair<std::string, std::uint64_t>> expected{{"compare_length", 2},
                                                                    {"compare_length.filter", 1},
                                                                    {"compare_length.integer", 1},
                                                                    {"compare_angle", 1},
                                                                    {"compare_angle.integer", 1}};
  EXPECT_EQ(counts.named(), expected);
}

}  // namespace
}  // namespace tribunal::laws
