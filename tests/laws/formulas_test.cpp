// Laws: every formula adds, subtracts and multiplies, and nothing else; each exact backend gives its true
// sign.
#include "predicates/formulas/compare_angle.hpp"
#include "predicates/formulas/compare_length.hpp"
#include "predicates/formulas/convexity.hpp"
#include "predicates/formulas/power_test.hpp"
#include "predicates/formulas/segment_intersection.hpp"
#include "predicates/formulas/size.hpp"
#include "tests/laws/backend_types.hpp"
#include "tests/laws/kernels.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <ostream>
#include <vector>

namespace tribunal::laws {
namespace {

// Operations of a formula, by a number type that knows only these three: another would not compile.

struct Operations {
  int sums = 0, products = 0;
  friend bool operator==(const Operations&, const Operations&) = default;
};
void PrintTo(const Operations& o, std::ostream* out) {
  *out << o.sums << " sums, " << o.products << " products";
}

/// A number that counts what is done with it, in a tally that it points to.
struct CountedNumber {
  std::int64_t value;
  Operations* tally;

  friend CountedNumber operator+(CountedNumber a, CountedNumber b) {
    return ++a.tally->sums, CountedNumber{a.value + b.value, a.tally};
  }
  friend CountedNumber operator-(CountedNumber a, CountedNumber b) {
    return ++a.tally->sums, CountedNumber{a.value - b.value, a.tally};
  }
  friend CountedNumber operator*(CountedNumber a, CountedNumber b) {
    return ++a.tally->products, CountedNumber{a.value * b.value, a.tally};
  }
};

template <class Formula>
Operations count_operations() {
  Operations tally;
  Arguments<CountedNumber, Formula> arguments;
  for (auto& point : arguments) point.fill({1, &tally});
  Formula::determinant(arguments);
  return tally;
}

TEST(Formula, AddsSubtractsAndMultipliesOnly) {
  EXPECT_EQ(count_operations<Orient<2>>(), (Operations{5, 2}));
  EXPECT_EQ(count_operations<Orient<3>>(), (Operations{14, 9}));
  EXPECT_EQ(count_operations<InSphere<2>>(), (Operations{14, 15}));
  EXPECT_EQ(count_operations<InSphere<3>>(), (Operations{37, 40}));
  EXPECT_EQ(count_operations<CompareLength<2>>(), (Operations{7, 4}));
  EXPECT_EQ(count_operations<CompareLength<3>>(), (Operations{11, 6}));
  EXPECT_EQ(count_operations<Cosine<2>>(), (Operations{5, 2}));
  EXPECT_EQ(count_operations<SineOfDifference>(), (Operations{13, 10}));
  EXPECT_EQ(count_operations<CompareCosineSquares<3>>(), (Operations{37, 24}));
  EXPECT_EQ(count_operations<PowerTest<2>>(), (Operations{24, 21}));
  EXPECT_EQ(count_operations<PowerTest<3>>(), (Operations{50, 48}));
}

TEST(Formula, IsHomogeneousOfItsDegree) {
  static_assert(formula_size<Orient<2>>.degree == 2 && formula_size<Orient<3>>.degree == 3);
  static_assert(formula_size<InSphere<2>>.degree == 4 && formula_size<InSphere<3>>.degree == 5);
  static_assert(formula_size<CompareLength<3>>.degree == 2 &&
                formula_size<CompareCosineSquares<3>>.degree == 8 &&
                formula_size<SineOfDifference>.degree == 4);
  static_assert(formula_size<PowerTest<2>>.degree == 4 && formula_size<PowerTest<3>>.degree == 5);
  SUCCEED() << "checked at compile time";
}

// Truth about small integers, in Boost's.

using Integer = boost::multiprecision::cpp_int;
Sign sign(const Integer& value) { return static_cast<Sign>(value.sign()); }

template <int D>
Integer dot(const Point<D>& a, const Point<D>& b, const Point<D>& c, const Point<D>& d) {
  Integer sum = 0;
  for (int i = 0; i < D; ++i) {
    const auto difference = [i](const Point<D>& p, const Point<D>& q) {
      return Integer(static_cast<std::int64_t>(q[i])) - static_cast<std::int64_t>(p[i]);
    };
    sum += difference(a, b) * difference(c, d);
  }
  return sum;
}

/// Half of the queries on small grids, where ties abound.
template <int D>
std::vector<Point<D>> draw_points(Random& random, int count) {
  std::vector<Point<D>> points;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t size = i < count / 2 ? 3 : std::uint64_t{1} << 30;
    points.push_back(draw_point<D>([&] { return static_cast<double>(random.below(size)); }));
  }
  return points;
}
template <class Formula>
Query<Formula> query_at(const std::vector<Point<Formula::dimension>>& points, std::size_t i) {
  Query<Formula> query;
  for (std::size_t k = 0; k < Formula::points; ++k) query[k] = points[i + k];
  return query;
}

template <int D>
void compares_lengths() {
  Random random(1);
  const auto points = draw_points<D>(random, 4000);
  const int asked = for_each_exact_backend<CompareLength<D>>(points, [&](const auto& backend) {
    int ties = 0;
    for (std::size_t i = 0; i + 4 <= points.size(); i += 4) {
      const auto p = query_at<CompareLength<D>>(points, i);
      const Sign truth = sign(dot<D>(p[0], p[1], p[0], p[1]) - dot<D>(p[2], p[3], p[2], p[3]));
      ties += truth == Sign::zero;
      ASSERT_EQ(backend.template decide<CompareLength<D>>(p).sign, truth);
    }
    EXPECT_GT(ties, 10);
  });
  EXPECT_GE(asked, 7);
}
TEST(CompareLength, IsExact) {
  compares_lengths<2>();
  compares_lengths<3>();
}

/// Near-ties in doubles: |p0 p1| and its mirror image, one coordinate an ulp longer.
TEST(CompareLength, SeesTheLastBit) {
  const double x = 0.75, y = 0.7, longer = std::nextafter(y, 1);
  for_each_exact_backend<CompareLength<2>>({{{0, 0}}, {{x, y}}, {{longer, x}}}, [&](const auto& backend) {
    using Formula = CompareLength<2>;
    EXPECT_EQ(backend.template decide<Formula>({{{{0, 0}}, {{x, y}}, {{0, 0}}, {{y, x}}}}).sign, Sign::zero);
    EXPECT_EQ(backend.template decide<Formula>({{{{0, 0}}, {{x, y}}, {{0, 0}}, {{longer, x}}}}).sign,
              Sign::negative);
  });
}

/// The cosine as an exact fraction: its sign, and its square as numerator and denominator.
template <int D>
struct ExactCosine {
  explicit ExactCosine(const Angle<D>& a)
      : dot(laws::dot<D>(a[1], a[0], a[1], a[2])),
        legs(laws::dot<D>(a[1], a[0], a[1], a[0]) * laws::dot<D>(a[1], a[2], a[1], a[2])) {}
  Integer dot, legs;
  Integer signed_square() const { return dot < 0 ? Integer(-dot * dot) : Integer(dot * dot); }
};

template <int D>
void compares_angles() {
  Random random(2);
  const auto points = draw_points<D>(random, 3000);
  const int asked = for_each_exact_backend<CompareCosineSquares<D>>(points, [&](const auto& backend) {
    int ties = 0;
    for (std::size_t i = 0; i + 6 <= points.size(); i += 6) {
      const Angle<D> a{points[i], points[i + 1], points[i + 2]},
          b{points[i + 3], points[i + 4], points[i + 5]};
      if (a[0] == a[1] || a[2] == a[1] || b[0] == b[1] || b[2] == b[1]) continue;
      const ExactCosine<D> first(a), second(b);
      const Sign truth = sign(second.signed_square() * first.legs - first.signed_square() * second.legs);
      ties += truth == Sign::zero;
      ASSERT_EQ(compare_angle<D>(backend, a, b).sign, truth);
      ASSERT_EQ(compare_angle<D>(backend, b, a).sign, -truth);
    }
    EXPECT_GT(ties, 3);
  });
  EXPECT_GE(asked, 7);
}
TEST(CompareAngle, IsExact) {
  compares_angles<2>();
  compares_angles<3>();
}

/// Right angles, straight ones, and those of similar triangles.
TEST(CompareAngle, KnowsTheSpecialAngles) {
  const Angle<2> right{{{{3, 4}}, {{0, 0}}, {{-8, 6}}}}, straight{{{{-5, 0}}, {{0, 0}}, {{7, 0}}}},
      zero{{{{1, 1}}, {{0, 0}}, {{3, 3}}}}, half_right{{{{9, 9}}, {{0, 0}}, {{0, 2}}}},
      other_half_right{{{{1, 3}}, {{0, 0}}, {{-1, 2}}}}, obtuse{{{{-1, 1}}, {{0, 0}}, {{5, 0}}}};
  const std::vector<Point2> box{{{-8, 0}}, {{9, 9}}};
  for_each_exact_backend<CompareCosineSquares<2>>(box, [&](const auto& backend) {
    const auto compare = [&](const Angle<2>& a, const Angle<2>& b) {
      return compare_angle<2>(backend, a, b).sign;
    };
    const std::vector<Angle<2>> ascending{zero, half_right, right, obtuse, straight};
    for (std::size_t i = 0; i < ascending.size(); ++i)
      for (std::size_t j = 0; j < ascending.size(); ++j)
        EXPECT_EQ(compare(ascending[i], ascending[j]), sign(Integer(i) - Integer(j))) << i << " " << j;
    EXPECT_EQ(compare(half_right, other_half_right), Sign::zero);
  });
}

/// With equal radii, and with the radii counted from anywhere, it is the in-sphere test.
template <int D, class B>
void is_in_sphere_for_equal_radii(const B& backend, const std::vector<Point<D + 1>>& balls) {
  int ties = 0;
  for (std::size_t i = 0; i + D + 3 <= balls.size(); i += D + 3) {
    auto p = query_at<PowerTest<D>>(balls, i);
    Case<D> centers{};
    for (int k = 0; k < D + 2; ++k) {
      p[k][D] = p[0][D];
      for (int axis = 0; axis < D; ++axis) centers[k][axis] = p[k][axis];
    }
    const Sign truth = true_in_sphere<D>(centers);
    ties += truth == Sign::zero;
    ASSERT_EQ(backend.template decide<PowerTest<D>>(p).sign, truth);
  }
  EXPECT_GT(ties, 10);
}
template <int D>
std::vector<Point<D + 1>> draw_balls() {
  Random random(3);
  std::vector<Point<D + 1>> balls(2000);
  for (auto& b : balls) b = draw_point<D + 1>([&] { return static_cast<double>(random.below(6)); });
  return balls;
}
TEST(PowerTest, OfEqualRadiiIsTheInSphereTest) {
  const auto balls = draw_balls<2>();
  const int asked = for_each_exact_backend<PowerTest<2>>(
      balls, [&](const auto& backend) { is_in_sphere_for_equal_radii<2>(backend, balls); });
  EXPECT_EQ(asked, 7);
}
/// Balls in space have four coordinates, more than a backend takes that is bound to a box.
TEST(PowerTest, OfEqualRadiiIsTheInSphereTestInSpace) {
  const auto balls = draw_balls<3>();
  const auto check = [&](const auto& backend) { is_in_sphere_for_equal_radii<3>(backend, balls); };
  EXPECT_TRUE((check_if_exact<IntervalArithmetic, PowerTest<3>>(balls, check)));
  EXPECT_TRUE((check_if_exact<Adaptive, PowerTest<3>>(balls, check)));
  EXPECT_TRUE((check_if_exact<Fixed, PowerTest<3>>(balls, check)));
  EXPECT_TRUE((check_if_exact<Gmp, PowerTest<3>>(balls, check)));
}

/// A ball grows into conflict: its power distance to the unit circle is |center|^2 - 1 - radius^2.
TEST(PowerTest, KnowsThePowerDistanceToTheUnitCircle) {
  const std::vector<Point3> circle{{{1, 0, 0}}, {{0, 1, 0}}, {{-1, 0, 0}}};  // points, counter-clockwise
  const Point3 origin{{0, 0, 0}};
  for_each_exact_backend<PowerTest<2>>({{{-1, 0, 0}}, {{0, 0, 0.25}}, {{3, 3, 3}}}, [&](const auto& backend) {
    for (double x = 0; x <= 3; x += 0.25)
      for (double radius = 0; radius <= 3; radius += 0.25) {
        const double power = x * x - 1 - radius * radius;  // exact
        const Query<PowerTest<2>> query{circle[0], circle[1], circle[2], {{x, 0, radius}}, origin};
        ASSERT_EQ(backend.template decide<PowerTest<2>>(query).sign, sign_of(-power)) << x << " " << radius;
      }
  });
}

/// Random weights against the homogeneous determinant with rows (1, x, y, x^2 + y^2 - r^2), in integers.
TEST(PowerTest, IsExactForRandomWeights) {
  Random random(4);
  const auto balls = draw_points<3>(random, 3000);
  auto bound = balls;
  bound.push_back({{0, 0, 0}});  // what the radii are measured from
  for_each_exact_backend<PowerTest<2>>(bound, [&](const auto& backend) {
    for (std::size_t i = 0; i + 5 <= balls.size(); i += 5) {
      auto p = query_at<PowerTest<2>>(balls, i);
      p[4] = {{0, 0, 0}};
      std::array<std::array<Integer, 3>, 3> row;  // differences from the query, and of lifts
      const auto integer = [](double x) { return Integer(static_cast<std::int64_t>(x)); };
      const auto lift = [&](const Point3& b) -> Integer {
        return integer(b[0]) * integer(b[0]) + integer(b[1]) * integer(b[1]) - integer(b[2]) * integer(b[2]);
      };
      for (int k = 0; k < 3; ++k)
        row[k] = {integer(p[k][0]) - integer(p[3][0]), integer(p[k][1]) - integer(p[3][1]),
                  lift(p[k]) - lift(p[3])};
      const Integer determinant = row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0]) -
                                  row[1][2] * (row[0][0] * row[2][1] - row[0][1] * row[2][0]) +
                                  row[2][2] * (row[0][0] * row[1][1] - row[0][1] * row[1][0]);
      ASSERT_EQ(backend.template decide<PowerTest<2>>(p).sign, sign(determinant));
    }
  });
}

// Classifications by the kernel's signs.

std::unique_ptr<const Kernel2> exact_plane() { return bind<2>(*find_backend("gmp"), {}); }

TEST(SegmentIntersection, ClassifiesEveryWayToMeet) {
  using enum SegmentIntersection;
  const auto kernel = exact_plane();
  const auto meet = [&](Point2 a, Point2 b, Point2 c, Point2 d) {
    return intersect_segments(*kernel, a, b, c, d);
  };
  EXPECT_EQ(meet({0, 0}, {4, 4}, {0, 4}, {4, 0}), crossing);
  EXPECT_EQ(meet({0, 0}, {4, 4}, {0, 4}, {2, 2}), touching) << "an end inside the other";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {4, 4}, {5, 0}), touching) << "a common end";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {0, 4}, {1, 3}), disjoint) << "short of the line";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {6, 4}, {4, 6}), disjoint) << "beyond the end";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {5, 5}, {5, 0}), disjoint) << "an end on the line, beyond the segment";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {1, 0}, {5, 4}), disjoint) << "parallel";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {5, 5}, {6, 6}), disjoint) << "collinear, apart";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {4, 4}, {6, 6}), touching) << "collinear, end to end";
  EXPECT_EQ(meet({0, 0}, {4, 4}, {3, 3}, {6, 6}), overlap);
  EXPECT_EQ(meet({0, 0}, {4, 4}, {1, 1}, {2, 2}), overlap) << "one inside the other";
  EXPECT_EQ(meet({0, 0}, {0, 4}, {0, 6}, {0, 2}), overlap) << "vertical";
}

/// All pairs of segments on a 3 x 3 grid, against their parameters at the meeting of their lines or, where
/// these are parallel, against the grid points that they share (a segment of two holds half points:
/// coordinates are doubled).
TEST(SegmentIntersection, AgreesWithSolvingForTheMeetingPoint) {
  const auto kernel = exact_plane();
  const auto node = [](int i) { return Point2{double(2 * (i % 3)), double(2 * (i / 3))}; };
  const auto cross = [](Point2 a, Point2 b, Point2 c, Point2 d) {
    return (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
  };
  const auto holds = [&](Point2 a, Point2 b, Point2 p) {
    return cross(p, a, p, b) == 0 && (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]) <= 0;
  };
  const auto expected = [&](Point2 a, Point2 b, Point2 c, Point2 d) {
    using enum SegmentIntersection;
    if (const double denominator = cross(a, b, c, d); denominator != 0) {
      const double s = cross(a, c, c, d) / denominator, t = cross(a, c, a, b) / denominator;
      if (s < 0 || s > 1 || t < 0 || t > 1) return disjoint;  // 0 and 1 divide without rounding
      return s == 0 || s == 1 || t == 0 || t == 1 ? touching : crossing;
    }
    int common = 0;
    for (double x = 0; x <= 4; ++x)
      for (double y = 0; y <= 4; ++y) common += holds(a, b, {x, y}) && holds(c, d, {x, y});
    return common == 0 ? disjoint : common == 1 ? touching : overlap;
  };
  for (int code = 0; code < 9 * 9 * 9 * 9; ++code) {
    const Point2 a = node(code % 9), b = node(code / 9 % 9), c = node(code / 81 % 9), d = node(code / 729);
    if (a == b || c == d) continue;
    ASSERT_EQ(intersect_segments(*kernel, a, b, c, d), expected(a, b, c, d)) << code;
  }
}

/// Barycentric coordinates by Cramer's rule, in integers.
TEST(Convexity, SignsAreThoseOfTheBarycentricCoordinates) {
  const auto kernel = bind<3>(*find_backend("gmp"), {});
  Random random(5);
  const auto orientation = [](const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const auto v = [&](const Point3& p, int i) { return p[i] - a[i]; };
    return v(b, 0) * (v(c, 1) * v(d, 2) - v(c, 2) * v(d, 1)) -
           v(b, 1) * (v(c, 0) * v(d, 2) - v(c, 2) * v(d, 0)) +
           v(b, 2) * (v(c, 0) * v(d, 1) - v(c, 1) * v(d, 0));
  };
  int convex = 0, met = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Point3, 4> t{};
    for (auto& p : t) p = draw_point<3>([&] { return static_cast<double>(random.below(4)); });
    const Point3 e = draw_point<3>([&] { return static_cast<double>(random.below(4)); });
    const double volume = orientation(t[0], t[1], t[2], t[3]);
    if (volume == 0) continue;
    const auto signs = barycentric_signs(*kernel, t, e);
    const std::array<double, 4> b{
        orientation(e, t[1], t[2], t[3]) / volume, orientation(t[0], e, t[2], t[3]) / volume,
        orientation(t[0], t[1], e, t[3]) / volume, orientation(t[0], t[1], t[2], e) / volume};
    for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(signs[k], sign_of(b[k]));
    ASSERT_NEAR(b[0] + b[1] + b[2] + b[3], 1, 1e-12);
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(b[0] * t[0][axis] + b[1] * t[1][axis] + b[2] * t[2][axis] + b[3] * t[3][axis], e[axis],
                  1e-12);
    // Strictly convex: the segment from 4 to e pierces the face (1,2,3), all orientations agreeing.
    const double through[3] = {orientation(t[3], e, t[0], t[1]), orientation(t[3], e, t[1], t[2]),
                               orientation(t[3], e, t[2], t[0])};
    const bool pierces = ((through[0] > 0 && through[1] > 0 && through[2] > 0) ||
                          (through[0] < 0 && through[1] < 0 && through[2] < 0)) &&
                         b[3] < 0;
    ASSERT_EQ(is_strictly_convex(signs), pierces);
    convex += pierces;
    ++met;
  }
  EXPECT_GT(convex, 100);
  EXPECT_GT(met, 10000);
}

}  // namespace
}  // namespace tribunal::laws
