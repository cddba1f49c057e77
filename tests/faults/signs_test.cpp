// The checker's signs against Boost's unbounded integers and the textbook determinants, on doubles chosen to
// hurt.
#include "algorithms/verify/exact_signs.hpp"
#include "datasets/random.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace tribunal::verify {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// A finite double in units of 2^-1074.
Integer in_smallest_units(double value) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int shift = exponent - 53 + 1074;  // negative for subnormals, whose mantissas then end in zeros
  return shift >= 0 ? Integer(mantissa) << shift : Integer(mantissa >> -shift);
}

Sign sign_of_integer(const Integer& value) { return static_cast<Sign>(value.sign()); }

Sign true_orientation(Point2 a, Point2 b, Point2 c) {
  const auto x = [](Point2 p) { return in_smallest_units(p[0]); };
  const auto y = [](Point2 p) { return in_smallest_units(p[1]); };
  return sign_of_integer(Integer((x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a))));
}

/// The lifted 4 x 4 determinant of rows (x, y, x^2 + y^2, 1): positive when d is inside the circle of a left
/// turn a, b, c.
Sign true_in_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const std::array<Point2, 4> points{a, b, c, d};
  std::array<Integer, 4> x, y, lift;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = in_smallest_units(points[i][0]);
    y[i] = in_smallest_units(points[i][1]);
    lift[i] = x[i] * x[i] + y[i] * y[i];
  }
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
    return Integer(x[i] * (y[j] - y[k]) + x[j] * (y[k] - y[i]) + x[k] * (y[i] - y[j]));
  };
  return sign_of_integer(Integer(lift[0] * minor(1, 2, 3) - lift[1] * minor(0, 2, 3) +
                                 lift[2] * minor(0, 1, 3) - lift[3] * minor(0, 1, 2)));
}

void expect_true_signs(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto show = [&] {
    char text[256];
    std::snprintf(text, sizeof text, "%a,%a %a,%a %a,%a %a,%a", a[0], a[1], b[0], b[1], c[0], c[1], d[0],
                  d[1]);
    return std::string(text);
  };
  EXPECT_EQ(orientation(a, b, c), true_orientation(a, b, c)) << show();
  // As polynomials the two are opposite, whatever the position of the points.
  EXPECT_EQ(opposite_angles(a, d, b, c), -true_in_circle(a, b, c, d)) << show();
}

/// Finite doubles of all magnitudes, with few bits or many.
double any_double(Random& random) {
  while (true) {
    std::uint64_t bits = random.bits();
    if (random.below(2) == 1) bits &= ~std::uint64_t{0} << 44;
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

double few_ulps_from(double value, Random& random) {
  for (std::uint64_t i = random.below(4); i > 0; --i)
    value = std::nextafter(value, random.below(2) == 1 ? std::numeric_limits<double>::max()
                                                       : -std::numeric_limits<double>::max());
  return value;
}

TEST(Signs, AreTrueForDoublesOfAllMagnitudes) {
  Random random(26);
  const auto point = [&] { return Point2{{any_double(random), any_double(random)}}; };
  for (int i = 0; i < 3000; ++i) expect_true_signs(point(), point(), point(), point());
}

TEST(Signs, AreTrueAtTheEndsOfTheRange) {
  Random random(27);
  constexpr double largest = std::numeric_limits<double>::max(), least = 0x1p-1074;
  const std::vector<double> ends{0,        -0.0,     least,     -least,    3 * least, 0x1p-1022, -0x1p-1022,
                                 0x1p-540, 0x1p-512, 0x1p-270,  -0x1p-256, 1,         -1,        0x1p+255,
                                 0x1p+256, 0x1p+511, -0x1p+512, 0x1p+1022, largest,   -largest,  0x1p+1023};
  const auto point = [&] {
    return Point2{{ends[random.below(ends.size())], ends[random.below(ends.size())]}};
  };
  for (int i = 0; i < 20000; ++i) expect_true_signs(point(), point(), point(), point());
}

// The squares of these differences underflow, all or some of them.
TEST(Signs, AreTrueAmongSubnormals) {
  Random random(28);
  for (const int exponent : {-1074, -1060, -1000, -550, -540, -530, -270, -266}) {
    const auto coordinate = [&] {
      return std::ldexp(static_cast<double>(random.below(41)) - 20,
                        exponent + static_cast<int>(random.below(3)));
    };
    const auto point = [&] { return Point2{{coordinate(), coordinate()}}; };
    for (int i = 0; i < 1500; ++i) expect_true_signs(point(), point(), point(), point());
  }
}

TEST(Signs, AreTrueWithinUlpsOfALine) {
  Random random(29);
  for (int i = 0; i < 5000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(41)) - 20);
    const auto near_line = [&] {
      const double t = scale * random.unit();
      return Point2{{few_ulps_from(t, random), few_ulps_from(0.75 * t + 0.5, random)}};
    };
    expect_true_signs(near_line(), near_line(), near_line(), near_line());
  }
}

TEST(Signs, AreTrueWithinUlpsOfACircle) {
  Random random(30);
  // Points of the unit circle with denominators 5, 13, 17, 25, 65; rounded, moved, then shaken by ulps.
  const std::vector<std::array<double, 2>> circle{{3. / 5, 4. / 5},
                                                  {5. / 13, 12. / 13},
                                                  {8. / 17, 15. / 17},
                                                  {7. / 25, 24. / 25},
                                                  {33. / 65, 56. / 65},
                                                  {16. / 65, 63. / 65},
                                                  {1, 0},
                                                  {0, 1}};
  for (int i = 0; i < 8000; ++i) {
    const double radius = std::ldexp(1.0, static_cast<int>(random.below(21)) - 10), shift = random.unit() * 8;
    const auto near_circle = [&] {
      const auto [c, s] = circle[random.below(circle.size())];
      const double x = (random.below(2) == 1 ? c : -c) * radius, y = (random.below(2) == 1 ? s : -s) * radius;
      return Point2{{few_ulps_from(x + shift, random), few_ulps_from(y - shift, random)}};
    };
    expect_true_signs(near_circle(), near_circle(), near_circle(), near_circle());
  }
}

TEST(Signs, AreZeroOnALineAndOnACircle) {
  Random random(31);
  std::vector<Point2> circle;  // the 36 lattice points at distance 65 from the origin
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65) circle.push_back({{static_cast<double>(x), static_cast<double>(y)}});
  ASSERT_EQ(circle.size(), 36U);
  for (const double unit : {0x1p-1074, 0x1p-300, 1.0, 0x1p+60, 0x1p+1000}) {
    for (int i = 0; i < 500; ++i) {
      const auto on_circle = [&] {
        const Point2 p = circle[random.below(circle.size())];
        return Point2{{p[0] * unit, p[1] * unit}};
      };
      const Point2 a = on_circle(), b = on_circle(), c = on_circle(), d = on_circle();
      EXPECT_EQ(opposite_angles(a, d, b, c), Sign::zero);
      EXPECT_EQ(orientation(a, {{3 * a[0], 3 * a[1]}}, {{-7 * a[0], -7 * a[1]}}), Sign::zero);
    }
  }
}

TEST(Signs, OfEnclosedAreasAddUpExactly) {
  const auto polygon = [](const std::vector<Point2>& corners) {
    std::vector<std::array<Point2, 2>> edges;
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return enclosed_area(edges);
  };
  EXPECT_EQ(polygon({{{0, 0}}, {{1, 0}}, {{0, 1}}}), Sign::positive);
  EXPECT_EQ(polygon({{{0, 0}}, {{0, 1}}, {{1, 0}}}), Sign::negative);
  EXPECT_EQ(polygon({{{0, 0}}, {{1e300, 0}}, {{0.5e300, 0}}}), Sign::zero);
  EXPECT_EQ(polygon({{{0, 0}}, {{1e300, 0}}, {{0.5e300, 5e-324}}}), Sign::positive);
  EXPECT_EQ(polygon({}), Sign::zero);
}

}  // namespace
}  // namespace tribunal::verify
