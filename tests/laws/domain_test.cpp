// Law: a backend refuses what lies outside its domain by naming the first such point, and nothing that lies
// inside.
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tribunal::laws {
namespace {

std::optional<Refusal> refusal(std::string_view backend, const std::vector<Point2>& points) {
  auto binding = find_backend(backend)->bind2(points);
  if (auto* refused = std::get_if<Refusal>(&binding)) return *refused;
  return std::nullopt;
}

class Domain : public EveryBackend {};

TEST_P(Domain, EveryBackendAcceptsNoPointsAtAllAndTheSharedDomain) {
  EXPECT_NE(bind<2>(entry(), {}), nullptr);
  EXPECT_NE(bind<2>(entry(), shared_domain<2>(100, 1).points()), nullptr);
  if (entry().bind3 == nullptr) return;
  EXPECT_NE(bind<3>(entry(), {}), nullptr);
  EXPECT_NE(bind<3>(entry(), shared_domain<3>(100, 1).points()), nullptr);
}

TEST_P(Domain, NonFiniteCoordinatesAreRefusedAtTheirPoint) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const auto refused = refusal(entry().about->name, {{{0, 0}}, {{1, 1}}, {{2, bad}}, {{bad, 3}}});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->point, 2u);
    EXPECT_FALSE(refused->reason.empty());
    if (entry().bind3 == nullptr) continue;
    const std::vector<Point3> points{{{0, 0, 0}}, {{1, 1, bad}}};
    const auto binding = entry().bind3(points);
    ASSERT_TRUE(std::holds_alternative<Refusal>(binding));
    EXPECT_EQ(std::get<Refusal>(binding).point, 1u);
  }
}

TEST_P(Domain, BoundPointsAreAdmittedAndNonFiniteOnesNever) {
  const auto family = shared_domain<2>(100, 2);
  const auto kernel = bind<2>(entry(), family.points());
  for (const Point2& p : family.points()) EXPECT_TRUE(kernel->admits(p));
  EXPECT_FALSE(kernel->admits({{std::nan(""), 0}}));
  EXPECT_FALSE(kernel->admits({{0, HUGE_VAL}}));
}

TRIBUNAL_FOR_EVERY_BACKEND(Domain);

TEST(KnuthDomain, ABoxOfWidth16383IsTheWidest) {
  for (const std::string_view name : {"knuth", "knuth-as-printed"})
    for (const double offset : {0.0, -8000.0, 0x1p52}) {
      EXPECT_FALSE(refusal(name, {{{offset, offset}}, {{offset + 16383, offset + 16383}}}));
      const auto refused =
          refusal(name, {{{offset, 0}}, {{offset + 1, 0}}, {{offset + 16384, 0}}, {{0, 1e9}}});
      ASSERT_TRUE(refused);
      EXPECT_EQ(refused->point, 2u);
      EXPECT_NE(refused->reason.find("wider than 16383"), std::string::npos) << refused->reason;
    }
  const auto fraction = refusal("knuth", {{{0, 0}}, {{1, 0.5}}});
  ASSERT_TRUE(fraction);
  EXPECT_EQ(fraction->point, 1u);
  EXPECT_EQ(fraction->reason, "y = 0.5 is no integer");
}

TEST(KnuthDomain, OnlyIntegersInTheBoxAreAdmitted) {
  const auto kernel = bind<2>(*find_backend("knuth"), {{{0, 0}}, {{100, 200}}});
  EXPECT_TRUE(kernel->admits({{100, 200}}));
  EXPECT_FALSE(kernel->admits({{101, 200}}));
  EXPECT_FALSE(kernel->admits({{50, 50.5}}));
}

/// All quadruples of the extreme lattice points: there every bound on magnitudes is met.
TEST(KnuthDomain, IsExactAtTheCornersOfTheWidestBox) {
  std::vector<Point2> corners;
  for (const double x : {0.0, 1.0, 16382.0, 16383.0})
    for (const double y : {0.0, 1.0, 16382.0, 16383.0}) corners.push_back({{x, y}});
  const auto kernel = bind<2>(*find_backend("knuth"), corners),
             truth = bind<2>(*find_backend("gmp"), corners);
  for (const auto& a : corners)
    for (const auto& b : corners)
      for (const auto& c : corners) {
        ASSERT_EQ(kernel->orient2d(a, b, c), truth->orient2d(a, b, c));
        for (const auto& d : corners) ASSERT_EQ(kernel->incircle(a, b, c, d), truth->incircle(a, b, c, d));
      }
}

TEST(Knuth64Domain, ABoxOfWidth2To30Minus1IsTheWidest) {
  constexpr double width = 0x1p30 - 1;
  for (const double offset : {0.0, -0x1p29, 0x1p52}) {
    EXPECT_FALSE(refusal("knuth64", {{{offset, offset}}, {{offset + width, offset + width}}}));
    const auto refused = refusal("knuth64", {{{offset, 0}}, {{offset + width + 1, 0}}});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->point, 1u);
    EXPECT_NE(refused->reason.find("wider than 1073741823"), std::string::npos) << refused->reason;
  }
}

TEST(Knuth64Domain, IsExactAtTheCornersOfTheWidestBox) {
  constexpr double width = 0x1p30 - 1;
  std::vector<Point2> corners;
  for (const double x : {0.0, 1.0, width - 1, width})
    for (const double y : {0.0, 1.0, width - 1, width}) corners.push_back({{x, y}});
  const auto kernel = bind<2>(*find_backend("knuth64"), corners),
             truth = bind<2>(*find_backend("gmp"), corners);
  for (const auto& a : corners)
    for (const auto& b : corners)
      for (const auto& c : corners) {
        ASSERT_EQ(kernel->orient2d(a, b, c), truth->orient2d(a, b, c));
        for (const auto& d : corners) ASSERT_EQ(kernel->incircle(a, b, c, d), truth->incircle(a, b, c, d));
      }
}

TEST(RedundantDomain, IsThatOfALatticeOf53Bits) {
  EXPECT_FALSE(refusal("redundant", {{{0, 0}}, {{0x1p53 - 1, 1}}}));
  EXPECT_TRUE(refusal("redundant", {{{0, 0}}, {{0x1p53, 1}}}));
  EXPECT_FALSE(refusal("redundant", {{{0x1p-1022, 0}}, {{0, 0x1p-1000}}}));
}

/// Digits and carries are stretched most where all differences have all their bits set.
TEST(RedundantDomain, IsExactAtTheCornersOfTheWidestBoxInSpace) {
  for (const double width : {0x1p28 - 1, 0x1p53 - 1}) {
    std::vector<Point3> corners;
    for (const double x : {0.0, width - 1, width})
      for (const double y : {0.0, width})
        for (const double z : {0.0, 1.0, width}) corners.push_back({{x, y, z}});
    const auto kernel = bind<3>(*find_backend("redundant"), corners);
    Random random(28);
    for (int i = 0; i < 20000; ++i) {
      Case<3> points{};
      for (auto& p : points) p = corners[random.below(corners.size())];
      ASSERT_EQ(orient(*kernel, points), true_orient<3>(points)) << hexadecimal<3>(points);
      ASSERT_EQ(in_sphere(*kernel, points), true_in_sphere<3>(points)) << hexadecimal<3>(points);
    }
  }
}

TEST(FixedDomain, TheWindowOfExponentsIs125Wide) {
  for (const double unit : {0x1p-1074, 1.0, 0x1p890}) {
    EXPECT_FALSE(refusal("fixed", {{{unit, -unit}}, {{0, 0x1.8p124 * unit}}}));
    const auto refused = refusal("fixed", {{{unit, 0}}, {{0x1p125 * unit, 0}}, {{1e300, 1e-300}}});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->point, 1u);
  }
  const auto kernel = bind<2>(*find_backend("fixed"), {{{1, 0}}, {{0x1p20, 0}}});
  EXPECT_TRUE(kernel->admits({{0x1p20 + 1, -7}}));
  EXPECT_FALSE(kernel->admits({{0.5, 1}})) << "finer than the window";
  EXPECT_FALSE(kernel->admits({{0x1p21, 1}})) << "beyond it";
}

/// Opposite ends of the window: differences of 126 bits, in-sphere determinants of 636.
TEST(FixedDomain, IsExactAtTheEndsOfTheWindow) {
  const std::vector<double> values{0x1.fffffffffffffp124, -0x1.fffffffffffffp124, 1, -1, 0x1p62, 0};
  const auto kernel = bind<3>(*find_backend("fixed"), {{{values[0], values[2], 0}}});
  Random random(126);
  for (int i = 0; i < 20000; ++i) {
    Case<3> points{};
    for (auto& p : points) p = draw_point<3>([&] { return values[random.below(values.size())]; });
    ASSERT_EQ(orient(*kernel, points), true_orient<3>(points)) << hexadecimal<3>(points);
    ASSERT_EQ(in_sphere(*kernel, points), true_in_sphere<3>(points)) << hexadecimal<3>(points);
  }
}

/// Single precision has 24 bits for a coordinate: two points become one, and a far one becomes infinite.
TEST(FloatDomain, CoordinatesAreRoundedToSinglePrecision) {
  const std::vector<Point2> points{{{0x1p24, 0}}, {{0x1p24 + 1, 1}}, {{0, 3}}, {{0x1p24, 1}}};
  const auto kernel = bind<2>(*find_backend("float"), points);
  EXPECT_EQ(kernel->orient2d(points[1], points[2], points[3]), Sign::zero);
  EXPECT_NE(true_orient<2>({points[1], points[2], points[3], points[0]}), Sign::zero);
  EXPECT_EQ(kernel->orient2d(points[0], {{0x1p200, 0x1p200}}, points[3]), Sign::zero)
      << "inf - inf has no sign";
}

TEST(FortuneVanWykDomain, DifferencesOf53BitsAreTheLongest) {
  const double most = 0x1p53 - 1;
  EXPECT_FALSE(refusal("fortune-van-wyk", {{{0, 0}}, {{most, 1}}}));
  EXPECT_FALSE(refusal("fortune-van-wyk", {{{-0x1p52, 0}}, {{0x1p52 - 1, 1}}}));
  for (const Point2& wide : {Point2{{0x1p53, 0}}, Point2{{-most, 0}}, Point2{{1e300, 0}}}) {
    const auto refused = refusal("fortune-van-wyk", {{{0, 0}}, {{1, 1}}, wide});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->point, 2u);
  }
}

TEST(FortuneVanWykDomain, OneTinyCoordinateMakesTheLatticeTooFineForTheOthers) {
  EXPECT_FALSE(refusal("fortune-van-wyk", {{{0, 0}}, {{1, 1}}, {{0x1p-52, 0}}}));
  const auto refused = refusal("fortune-van-wyk", {{{0, 0}}, {{1, 1}}, {{0x1p-53, 0}}});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->point, 2u);
}

TEST(FortuneVanWykDomain, TheUnitMayBeAnyNormalPowerOfTwo) {
  EXPECT_FALSE(refusal("fortune-van-wyk", {{{0, 0}}, {{0x1p-1022, 0x1p-1000}}}));
  const auto refused = refusal("fortune-van-wyk", {{{0, 0}}, {{0x1p-1023, 0}}});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->point, 1u);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_FALSE(refusal("fortune-van-wyk", {{{0, 0}}, {{largest, 0x1p1023}}}));
  EXPECT_TRUE(refusal("fortune-van-wyk", {{{-largest, 0}}, {{largest, 0}}})) << "the difference overflows";
}

TEST(FortuneVanWykDomain, OnlyLatticePointsOfTheBoxAreAdmitted) {
  const auto kernel = bind<2>(*find_backend("fortune-van-wyk"), {{{-1, -1}}, {{1, 0.25}}});
  EXPECT_TRUE(kernel->admits({{0.75, 0.25}}));
  EXPECT_FALSE(kernel->admits({{0.75, 0.5}})) << "outside the box";
  EXPECT_FALSE(kernel->admits({{0.125, 0}})) << "off the lattice";

  const auto coarse = bind<2>(*find_backend("fortune-van-wyk"), {{{0, 0}}, {{0x1p900, 0x1p900}}});
  EXPECT_FALSE(coarse->admits({{0x1p-1000, 0}})) << "in its units this underflows to zero";
}

TEST(UnboundedDomain, AnyFiniteDoublesAreAccepted) {
  const double largest = std::numeric_limits<double>::max(),
               least = std::numeric_limits<double>::denorm_min();
  for (const std::string_view name :
       {"double", "double-fma", "float", "long-double", "interval", "adaptive", "filtered", "gmp"})
    EXPECT_FALSE(refusal(name, {{{-largest, least}}, {{largest, -least}}, {{-0.0, 0.1}}}));
}

}  // namespace
}  // namespace tribunal::laws
