// Law: a decision names the stage that really made it.
#include "predicates/backends/all.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <variant>
#include <vector>

namespace tribunal::laws {
namespace {

/// Any two decisions are comparable at once.
std::pair<Sign, Stage> parts(Decision d) { return {d.sign, d.stage}; }

constexpr auto filter_plus = std::pair(Sign::positive, Stage::filter);
constexpr auto integer_zero = std::pair(Sign::zero, Stage::integer);

TEST(Stage, FilteredDecidesClearCasesByItsFilter) {
  const auto kernel = bind<2>(*find_backend("filtered"), {{{0.1, 0.2}}, {{0.7, 0.3}}, {{0.4, 0.9}}});
  EXPECT_EQ(parts(kernel->decide_orient2d({{0.1, 0.2}}, {{0.7, 0.3}}, {{0.4, 0.9}})), filter_plus);
  EXPECT_EQ(parts(kernel->decide_incircle({{0.1, 0.2}}, {{0.7, 0.3}}, {{0.4, 0.9}}, {{0.4, 0.4}})),
            filter_plus);
}

TEST(Stage, FilteredDecidesZerosOnALatticeByIntegers) {
  const std::vector<Point2> square{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}, {{2, 2}}};
  const auto kernel = bind<2>(*find_backend("filtered"), square);
  EXPECT_EQ(parts(kernel->decide_orient2d(square[0], square[2], square[4])), integer_zero);
  EXPECT_EQ(parts(kernel->decide_incircle(square[0], square[1], square[2], square[3])), integer_zero);
  const auto cube = bind<3>(*find_backend("filtered"), {{{0, 0, 0}}, {{1, 1, 1}}});
  EXPECT_EQ(parts(cube->decide_orient3d({{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}})), integer_zero);
  EXPECT_EQ(parts(cube->decide_insphere({{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 1}})),
            integer_zero);
}

TEST(Stage, FilteredDecidesZerosWithoutALatticeByGmp) {
  const std::vector<Point2> points{{{1e-300, 1e-300}}, {{1, 1}}, {{0.1, 0.1}}, {{1e300, 1e300}}};
  const auto kernel = bind<2>(*find_backend("filtered"), points);
  EXPECT_EQ(parts(kernel->decide_orient2d(points[0], points[1], points[2])),
            std::pair(Sign::zero, Stage::exact));
}

constexpr auto double_double_plus = std::pair(Sign::positive, Stage::double_double);

/// The frame's integers would truncate these differences to zero.
TEST(Stage, APointOffTheLatticeNeverReachesItsIntegers) {
  const auto kernel = bind<2>(*find_backend("filtered"), {{{0, 0}}, {{64, 64}}});
  const Point2 off{{0x1p-60, 0}}, further{{0x1p-100, 0}};
  EXPECT_TRUE(kernel->admits(off));
  EXPECT_EQ(parts(kernel->decide_orient2d({{64, 64}}, {{64, 64}}, further)),
            std::pair(Sign::zero, Stage::integer));  // of the query's own window
  EXPECT_EQ(parts(kernel->decide_orient2d({{64, 64}}, {{1, 1}}, off)), double_double_plus);
}

/// Between queries of the data's box and all of space, the threshold of the box tells.
TEST(Stage, FilteredAdmitsABoxAroundItsPoints) {
  const auto kernel = bind<2>(*find_backend("filtered"), {{{0, 0}}, {{64, 16}}});
  EXPECT_TRUE(kernel->admits({{-16, 32}}));
  EXPECT_TRUE(kernel->admits({{80, -16}}));
  EXPECT_FALSE(kernel->admits({{80.5, 0}}));
  EXPECT_FALSE(kernel->admits({{0, -16.5}}));
  EXPECT_TRUE(bind<2>(*find_backend("filtered"), {})->admits({{0x1p1023, -0x1p-1074}}));
}

/// Uniform doubles need 53 bits and some; what the filter leaves open of them, pairs of doubles decide.
TEST(Stage, FilteredDecidesCloseCasesWithoutALatticeByDoubleDoubles) {
  const std::vector<Point2> points{{{0x1p-80, 0}}, {{0.1, 0.1}}, {{0.3, 0.3}}, {{0.2, 0.2}}, {{1, 1}}};
  const auto kernel = bind<2>(*find_backend("filtered"), points);
  const Decision decision = kernel->decide_orient2d(points[1], points[2], points[3]);
  EXPECT_EQ(decision.sign, true_orient<2>({points[1], points[2], points[3], points[0]}));
  const Point2 above{{0.2, std::nextafter(0.2, 1)}};
  EXPECT_EQ(parts(kernel->decide_orient2d(points[1], points[2], above)), double_double_plus);
}

/// One binary place decides which integers serve: 61 fit a word, 125 two, 126 none.
TEST(Stage, ExponentWindowsEndWhereTheirIntegersDo) {
  const auto kernel = bind<2>(*find_backend("filtered"), {});
  const auto stage = [&](double wide) { return kernel->decide_orient2d({{1, 1}}, {{3, 3}}, {{wide, wide}}); };
  EXPECT_EQ(parts(stage(0x1p60)), integer_zero);
  EXPECT_EQ(parts(stage(0x1p61)), integer_zero);
  EXPECT_EQ(parts(stage(0x1p124)), integer_zero);
  EXPECT_EQ(parts(stage(0x1p125)), std::pair(Sign::zero, Stage::exact));
}

/// A minor that underflows to zero meets 2^100: its true share 2^-976 outweighs the only one left, -2^-1038.
/// Without the smallest normal inside each product the filter would certify the wrong sign.
TEST(Stage, UnderflowUnderALargeFactorIsNotCertified) {
  const auto spatial = bind<3>(*find_backend("filtered"), {});
  const Case<3> tetrahedron{
      {{{0, 0, 0}}, {{0x1p-500, 0, 0x1p100}}, {{0x1p-538, 0, 1}}, {{0, 0x1p-538, 0}}, {{0, 0, 0}}}};
  EXPECT_EQ(true_orient<3>(tetrahedron), Sign::positive);
  EXPECT_EQ(parts(decide_orient(*spatial, tetrahedron)), std::pair(Sign::positive, Stage::exact));

  const auto planar = bind<2>(*find_backend("filtered"), {});
  const Case<2> circle{{{{0, 0x1p100}}, {{0x1p-538, 0}}, {{0x1p-300, 0x1p-538}}, {{0, 0}}}};
  EXPECT_EQ(true_in_sphere<2>(circle), Sign::positive);
  EXPECT_EQ(parts(decide_in_sphere(*planar, circle)), std::pair(Sign::positive, Stage::exact));
}

TEST(Stage, OverflowIsNotCertified) {
  const auto kernel = bind<2>(*find_backend("filtered"), {});
  const Case<2> points{{{{-0x1p1023, -0x1p1023}}, {{0x1p1023, 0x1p1022}}, {{0x1p1023, 0x1p1023}}, {{0, 0}}}};
  EXPECT_EQ(parts(decide_orient(*kernel, points)), std::pair(Sign::positive, Stage::integer));
}

TEST(Stage, FortuneVanWykFiltersByAConstantThenUsesIntegers) {
  const double side = 0x1p28 - 1;
  const std::vector<Point2> square{{{0, 0}}, {{side, 0}}, {{side, side}}, {{0, side}}, {{1, 1}}};
  const auto kernel = bind<2>(*find_backend("fortune-van-wyk"), square);
  EXPECT_EQ(parts(kernel->decide_orient2d(square[0], square[1], square[2])), filter_plus);
  EXPECT_EQ(parts(kernel->decide_orient2d(square[0], square[2], square[4])), integer_zero);
  EXPECT_EQ(parts(kernel->decide_incircle(square[0], square[1], square[2], square[4])), filter_plus);
  EXPECT_EQ(parts(kernel->decide_incircle(square[0], square[1], square[2], square[3])), integer_zero);
}

/// With 26 bits for orientation and 12 for circles nothing is rounded, so that a zero is certain.
TEST(Stage, FortuneVanWykFilterDecidesZerosOfSmallData) {
  for (const double scale : {1.0, 0x1p-200, 0x1p200}) {
    const std::vector<Point2> square{
        {{0, 0}}, {{4095 * scale, 0}}, {{4095 * scale, 4095 * scale}}, {{0, 4095 * scale}}};
    const auto kernel = bind<2>(*find_backend("fortune-van-wyk"), square);
    EXPECT_EQ(parts(kernel->decide_incircle(square[0], square[1], square[2], square[3])),
              std::pair(Sign::zero, Stage::filter));
  }
}

/// Where the determinant could underflow, there is no constant, and integers decide all.
TEST(Stage, FortuneVanWykFilterStaysSilentAtExtremeScales) {
  for (const double unit : {0x1p-1000, 0x1p960}) {
    const std::vector<Point2> points{{{0, 0}}, {{3 * unit, 0}}, {{0, 3 * unit}}, {{unit, unit}}};
    const auto kernel = bind<2>(*find_backend("fortune-van-wyk"), points);
    EXPECT_EQ(parts(kernel->decide_orient2d(points[0], points[1], points[2])),
              std::pair(Sign::positive, Stage::integer));
    EXPECT_EQ(parts(kernel->decide_incircle(points[0], points[1], points[2], points[3])),
              std::pair(Sign::positive, Stage::integer));
  }
}

/// Differences that are exact stay single points, and so does their sum; a product does not.
TEST(Stage, IntervalDecidesZerosOfProductsExactly) {
  const std::vector<Point2> points{{{0.1, 0.2}}, {{0.7, 0.3}}, {{0.4, 0.9}}, {{0.1, 0.2}}};
  const auto kernel = bind<2>(*find_backend("interval"), points);
  EXPECT_EQ(parts(kernel->decide_orient2d(points[0], points[1], points[2])), filter_plus);
  EXPECT_EQ(parts(kernel->decide_orient2d(points[0], points[1], points[3])),
            std::pair(Sign::zero, Stage::exact));
}

TEST(Stage, AdaptiveDecidesByExpansionsWhereTheyAreExact) {
  const auto kernel = bind<2>(*find_backend("adaptive"), {});
  const auto expansion_zero = std::pair(Sign::zero, Stage::expansion);
  EXPECT_EQ(parts(kernel->decide_orient2d({{0.1, 0.2}}, {{0.7, 0.3}}, {{0.4, 0.9}})), filter_plus);
  EXPECT_EQ(parts(kernel->decide_orient2d({{0.1, 0.1}}, {{0.7, 0.7}}, {{0.4, 0.4}})), expansion_zero);
  for (const double scale : {0x1p-1074, 0x1p-1022, 0x1p-600, 0x1p1020})  // where products leave the range
    EXPECT_EQ(parts(kernel->decide_orient2d({{0, 0}}, {{3 * scale, 3 * scale}}, {{scale, scale}})),
              expansion_zero);
}

/// Orientation is of degree 2: bits may lie (1018 + 1074) / 2 places apart at most, or so.
TEST(Stage, AdaptiveLeavesTheWidestExponentWindowsToGmp) {
  const auto kernel = bind<2>(*find_backend("adaptive"), {});
  const auto stage = [&](double wide) {
    return kernel->decide_orient2d({{0, 0}}, {{1, 1}}, {{wide, wide}}).stage;
  };
  EXPECT_EQ(stage(0x1p1000), Stage::expansion);
  EXPECT_EQ(stage(0x1p-1000), Stage::expansion);
  const auto spread = kernel->decide_orient2d({{0x1p-1000, 0x1p-1000}}, {{0, 0}}, {{0x1p1000, 0x1p1000}});
  EXPECT_EQ(parts(spread), std::pair(Sign::zero, Stage::exact));
}

TEST(Stage, OneStageBackendsAlwaysNameTheirs) {
  const auto points = shared_domain<2>(1, 5).points();
  const auto stage = [&](std::string_view name) {
    return bind<2>(*find_backend(name), points)->decide_orient2d(points[0], points[1], points[2]).stage;
  };
  EXPECT_EQ(stage("double"), Stage::rounded);
  EXPECT_EQ(stage("double-fma"), Stage::rounded);
  EXPECT_EQ(stage("float"), Stage::rounded);
  EXPECT_EQ(stage("long-double"), Stage::rounded);
  EXPECT_EQ(stage("knuth-as-printed"), Stage::rounded);
  EXPECT_EQ(stage("knuth"), Stage::integer);
  EXPECT_EQ(stage("knuth64"), Stage::integer);
  EXPECT_EQ(stage("redundant"), Stage::integer);
  EXPECT_EQ(stage("fixed"), Stage::integer);
  EXPECT_EQ(stage("gmp"), Stage::exact);
}

/// Law: a backend called directly and through the interface makes the same decisions.
template <class B>
class Erasure : public testing::Test {};
template <class... B>
testing::Types<B...> to_test_types(BackendTypes<B...>);
using EveryListed = decltype(to_test_types(AllBackends{}));
TYPED_TEST_SUITE(Erasure, EveryListed);

TYPED_TEST(Erasure, ChangesNoDecision) {
  const auto points_of = [](const auto& family) { return family.points(); };
  const auto planar = shared_domain<2>(500, 3);
  const auto plane = points_of(planar);
  const auto direct = std::get<TypeParam>(TypeParam::bind(std::span<const Point2>(plane)));
  const auto erased = bind<2>(*find_backend(TypeParam::about.name), plane);
  for (const auto& p : planar.cases) {
    EXPECT_EQ(parts(direct.template decide<Orient<2>>({p[0], p[1], p[2]})), parts(decide_orient(*erased, p)));
    EXPECT_EQ(parts(direct.template decide<InSphere<2>>({p[0], p[1], p[2], p[3]})),
              parts(decide_in_sphere(*erased, p)));
  }
  if constexpr (Backend<TypeParam, 3>) {
    const auto spatial = shared_domain<3>(500, 4);
    const auto space = points_of(spatial);
    const auto direct3 = std::get<TypeParam>(TypeParam::bind(std::span<const Point3>(space)));
    const auto erased3 = bind<3>(*find_backend(TypeParam::about.name), space);
    for (const auto& p : spatial.cases) {
      EXPECT_EQ(parts(direct3.template decide<Orient<3>>({p[0], p[1], p[2], p[3]})),
                parts(decide_orient(*erased3, p)));
      EXPECT_EQ(parts(direct3.template decide<InSphere<3>>({p[0], p[1], p[2], p[3], p[4]})),
                parts(decide_in_sphere(*erased3, p)));
    }
  }
}

}  // namespace
}  // namespace tribunal::laws
