// Angles as they are shown.
#include "algorithms/refinement/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tribunal::refinement {
namespace {

TEST(Shape, ExtremeAnglesOfTheEquilateralAndTheRightTriangle) {
  const auto equilateral = extreme_angles({{{{0, 0}}, {{1, 0}}, {{0.5, std::sqrt(3) / 2}}}});
  EXPECT_NEAR(equilateral[0], 60, 1e-12);
  EXPECT_NEAR(equilateral[1], 60, 1e-12);
  const auto right = extreme_angles({{{{0, 0}}, {{3, 0}}, {{0, 4}}}});
  EXPECT_NEAR(right[0], 36.86989764584402, 1e-12);
  EXPECT_DOUBLE_EQ(right[1], 90);
}

/// Counter-clockwise, but the rounded product of two of its sides says otherwise.
TEST(Shape, AnglesOfAFlatTriangleAreNotNegative) {
  const Corners flat{{{{0x1.000000000008bp-1, 0x1.0000000000096p-1}}, {{12, 12}}, {{24, 24}}}};
  const auto [smallest, largest] = extreme_angles(flat);
  EXPECT_GE(smallest, 0);
  EXPECT_LT(smallest, 1e-12);
  EXPECT_GT(largest, 180 - 1e-12);
  EXPECT_LE(largest, 180);
}

}  // namespace
}  // namespace tribunal::refinement
