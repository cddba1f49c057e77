// Laws of the costs: what they are on surfaces that can be written down, and what a flip changes.
#include "algorithms/data_dependent/roughness.hpp"

#include "tests/data_dependent/support.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace tribunal::data_dependent {
namespace {

/// A roof over the square from (-1,-1) to (1,1) with its ridge along x = 0 and slopes of +-s.
struct Roof {
  std::vector<Point2> points{{0, -1}, {0, 1}, {-1, 0}, {1, 0}};
  std::vector<double> values;
  explicit Roof(double s) : values{0, 0, -s, -s} {}
  double cost(Cost cost, Norm norm = Norm::l1) const {
    return Roughness(points, values, cost, norm).across(0, 1, 2, 3);
  }
};

TEST(Roughness, JumpIsTheDifferenceOfSlopes) {
  EXPECT_DOUBLE_EQ(Roof(3).cost(Cost::jump_in_normal_derivatives), 6);
  EXPECT_DOUBLE_EQ(Roof(3).cost(Cost::jump_in_normal_derivatives, Norm::l2), 36);
}

/// Normals of slopes 10 and -10: cos = (1 - 100) / 101, far from acute.
TEST(Roughness, NormalsOfASteepRoofAreObtuse) {
  EXPECT_NEAR(Roof(10).cost(Cost::angle_between_normals) * 180 / std::numbers::pi, 168.5788, 1e-4);
  EXPECT_NEAR(Roof(1).cost(Cost::angle_between_normals), std::numbers::pi / 2, 1e-15);
}

/// The arc cosine of the formula would return 0 or 1.5e-8.
TEST(Roughness, SmallAnglesKeepTheirDigits) {
  EXPECT_NEAR(Roof(1e-9).cost(Cost::angle_between_normals) / 2e-9, 1, 1e-12);
}

TEST(Roughness, FlatSurfacesCostNothing) {
  const Scatter scatter(50, 3);
  std::vector<double> values;
  for (const Point2& p : scatter.points) values.push_back(2 * p[0] - 3 * p[1] + 1);
  for (const Cost cost : {Cost::jump_in_normal_derivatives, Cost::angle_between_normals})
    EXPECT_LT(Roughness(scatter.points, values, cost, Norm::l1).total(EdgeMesh(scatter.delaunay)), 1e-10);
}

TEST(Roughness, TheOrderOfNamesDoesNotShowInABit) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    std::vector<Point2> points(4);
    std::vector<double> values(4);
    for (int k = 0; k < 4; ++k) {
      points[k] = {random.unit(), random.unit()};
      values[k] = random.unit();
    }
    for (const Cost cost : {Cost::jump_in_normal_derivatives, Cost::angle_between_normals}) {
      const Roughness roughness(points, values, cost, Norm::l1);
      const double reference = roughness.across(0, 1, 2, 3);
      EXPECT_EQ(roughness.across(1, 0, 2, 3), reference);
      EXPECT_EQ(roughness.across(0, 1, 3, 2), reference);
      EXPECT_EQ(roughness.across(1, 0, 3, 2), reference);
    }
  }
}

TEST(Roughness, AFlipChangesTheSumByWhatItsFiveEdgesChange) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scatter scatter(60, seed);
    const auto values = sample(franke_functions()[0], scatter.points);
    EdgeMesh mesh(scatter.delaunay);
    const Roughness roughness(scatter.points, values, Cost::angle_between_normals, Norm::l2);
    for (Index edge = 0; edge < mesh.edges(); ++edge) {
      if (!RoughMesh{scatter.sites(), mesh, roughness}.is_flippable(edge)) continue;
      const Roughness::Change change = roughness.change_by_flip(mesh, edge);
      const double before = roughness.total(mesh);
      mesh.flip(edge);
      EXPECT_NEAR(before - roughness.total(mesh), change.gain(), 1e-12 * before);
      const Roughness::Change back = roughness.change_by_flip(mesh, edge);
      EXPECT_NEAR(back.gain(), -change.gain(), 1e-12 * before);
      EXPECT_FALSE(change.is_better() && back.is_better());
    }
  }
}

/// Where a gradient overflows or is no number, nothing gains.
TEST(Roughness, WhatIsNoNumberIsNoGain) {
  constexpr double infinite = std::numeric_limits<double>::infinity(),
                   no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE((Roughness::Change{1, no_number}.is_better()));
  EXPECT_FALSE((Roughness::Change{no_number, 1}.is_better()));
  EXPECT_FALSE((Roughness::Change{infinite, infinite}.is_better()));
  EXPECT_TRUE((Roughness::Change{infinite, 1}.is_better()));
  EXPECT_FALSE((Roughness::Change{1, 1}.is_better()));
  EXPECT_FALSE((Roughness::Change{0, 0}.is_better()));
}

TEST(Franke, FunctionsAtPlacesWhereTheyCanBeWorkedOut) {
  const auto& f = franke_functions();
  EXPECT_DOUBLE_EQ(f[1].value({0.3, 0.3}), 1.0 / 9);
  EXPECT_DOUBLE_EQ(f[2].value({1.0 / 3, 0}), 2.25 / 6);
  EXPECT_DOUBLE_EQ(f[3].value({0.5, 0.5}), 1.0 / 3);
  EXPECT_DOUBLE_EQ(f[4].value({0.5, 0.5}), 1.0 / 3);
  EXPECT_DOUBLE_EQ(f[5].value({0.5, 0.5}), 8.0 / 9 - 0.5);
  EXPECT_NEAR(f[0].value({2.0 / 9, 2.0 / 9}),
              0.75 + 0.75 * std::exp(-9.0 / 49 - 0.3) + 0.5 * std::exp(-6.5) - 0.2 * std::exp(-29.0), 1e-15);
  EXPECT_DOUBLE_EQ(f[5].value({9, 9}), -0.5);
}

}  // namespace
}  // namespace tribunal::data_dependent
