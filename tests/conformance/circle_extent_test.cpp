// The bound by which Watson's list retires circles lies right of the circle, never left of it.
#include "algorithms/insertion/circle_extent.hpp"

#include "datasets/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tribunal {
namespace {

/// True when `bound` is at least c_x + r, exactly: with the centre (x, y) relative to a and g = bound - a_x -
/// x, that is g >= 0 and g^2 >= x^2 + y^2, in rationals.
bool covers(double bound, const Point2& a, const Point2& b, const Point2& c) {
  if (std::isinf(bound)) return bound > 0;
  const mpq_class bx = mpq_class(b[0]) - a[0], by = mpq_class(b[1]) - a[1];
  const mpq_class cx = mpq_class(c[0]) - a[0], cy = mpq_class(c[1]) - a[1];
  const mpq_class d = 2 * (bx * cy - by * cx);
  if (d == 0) return false;
  const mpq_class b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const mpq_class x = (cy * b2 - by * c2) / d, y = (bx * c2 - cx * b2) / d;
  const mpq_class g = mpq_class(bound) - a[0] - x;
  return g >= 0 && g * g >= x * x + y * y;
}

TEST(RightExtent, CoversTheCircle) {
  Random random(1);
  int finite = 0;
  for (int i = 0; i < 20000; ++i) {
    const double flatness = std::ldexp(1.0, -static_cast<int>(random.below(60)));
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100),
                 shift = random.unit() * 8;
    Point2 p[3];
    for (auto& q : p) q = {(random.unit() + shift) * scale, random.unit() * flatness * scale};
    const double bound = right_extent(p[0], p[1], p[2]);
    finite += std::isfinite(bound);
    ASSERT_TRUE(covers(bound, p[0], p[1], p[2])) << i;
  }
  EXPECT_GT(finite, 10000);
}

TEST(RightExtent, IsTightForRoundTriangles) {
  EXPECT_NEAR(right_extent({0, 0}, {1, 0}, {0, 1}), 0.5 + std::sqrt(0.5), 1e-11);
  EXPECT_NEAR(right_extent({1000, 5}, {998, 5}, {999, 6}), 1000, 1e-9);
}

TEST(RightExtent, CollinearOrExtremePointsHaveNoBound) {
  EXPECT_TRUE(std::isinf(right_extent({0, 0}, {1, 1}, {2, 2})));
  EXPECT_TRUE(std::isinf(right_extent({0, 0}, {0x1p1000, 1}, {2, 0x1p1000})));
  EXPECT_TRUE(std::isinf(right_extent({0, 0}, {0x1p-1000, 0}, {0, 0x1p-1000})));
}

}  // namespace
}  // namespace tribunal
