// docs/errata.md, item by item: what the text prints fails on a witness where what it means holds.
#include "predicates/arithmetic/redundant_as_printed.hpp"
#include "predicates/arithmetic/redundant_integer.hpp"
#include "predicates/backends/gmp.hpp"
#include "predicates/formulas/compare_angle.hpp"
#include "predicates/formulas/convexity.hpp"
#include "predicates/symbolic/simulation_of_simplicity.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <set>
#include <vector>

namespace tribunal::laws {
namespace {

using Words = Triple<std::int32_t>;

std::unique_ptr<const Kernel2> plane() { return bind<2>(*find_backend("gmp"), {}); }
std::unique_ptr<const Kernel3> space() { return bind<3>(*find_backend("gmp"), {}); }

/// Three products of 15-bit factors at most: 64 bits hold the sum.
Sign sign_of_sum(const Words& x, const Words& y) {
  std::int64_t sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::int64_t{x[i]} * y[i];
  return sign_of(sum);
}

TEST(Errata, Item1TheThirdProductOverwritesTheSums) {
  constexpr Words x{-1, -1, 1}, y{0, 1, 1};
  EXPECT_EQ(sign_of_sum(x, y), Sign::zero);
  EXPECT_EQ(sign_of_dot_product_as_printed(x, y, as_printed), Sign::negative);
  EXPECT_EQ(sign_of_dot_product_as_printed(x, y, {.third_product_overwrites = false}), Sign::zero);
}

TEST(Errata, Item2TheCarryOverwritesTheHighDigit) {
  constexpr Words x{19317, 1444, -18836}, y{24311, 26904, 14696};
  EXPECT_EQ(sign_of_sum(x, y), Sign::positive);
  EXPECT_EQ(sign_of_dot_product_as_printed(x, y, {.third_product_overwrites = false}), Sign::negative);
  EXPECT_EQ(sign_of_dot_product_as_printed(x, y, all_corrected), Sign::positive);
}

/// Of random factors that nearly cancel, where the exits are reached.
TEST(Errata, Item3TheLateExitsAreHarmless) {
  Random random(3);
  constexpr Misprints late{.third_product_overwrites = false, .carry_overwrites = false, .late_exits = true};
  for (int i = 0; i < 100000; ++i) {
    const auto draw = [&] { return static_cast<std::int32_t>(random.below(1 << 15)); };
    Words x{draw(), draw(), 0}, y{draw(), draw(), 1 + draw()};
    x[2] = static_cast<std::int32_t>(-(std::int64_t{x[0]} * y[0] + std::int64_t{x[1]} * y[1]) / y[2]);
    if (x[2] <= -(1 << 28)) continue;
    ASSERT_EQ(sign_of_dot_product_as_printed(x, y, late),
              sign_of_dot_product_as_printed(x, y, all_corrected));
  }
}

TEST(Errata, Item5TheMiddleDigitIsLargerThanTheTextSays) {
  RedundantInteger<std::int32_t> sum;
  constexpr std::int32_t largest = (1 << 28) - 1;
  sum.add_product(1, largest, largest);
  sum.add_product(1, largest, largest);
  EXPECT_GE(sum.b, 1 << 29);
  EXPECT_LT(sum.b, 1 << 30);
  EXPECT_LT(sum.a, 1 << 29);
  EXPECT_LT(sum.c, 1 << 29);
}

/// s1 = s2 >= 0 > s3 cannot be had from signs +, 0, - by reordering and negating the data; the test works all
/// the same.
TEST(Errata, Item6TheReorderingIsImpossible) {
  std::array<int, 3> s{-1, 0, 1};
  do {
    for (const int negate : {1, -1}) {
      const int s1 = negate * s[0], s2 = negate * s[1], s3 = negate * s[2];
      EXPECT_FALSE(s1 == s2 && s2 >= 0 && s3 < 0);
    }
  } while (std::next_permutation(s.begin(), s.end()));
  EXPECT_EQ(sign_of_dot_product<std::int32_t>({5, 0, -7}, {3, 9, 2}), Sign::positive);
}

TEST(Errata, Item7WithLessOrEqualNoAngleVectorEqualsItself) {
  const std::vector<int> a{30, 60, 90}, b{30, 70, 80};
  const auto less_as_printed = [](const std::vector<int>& u, const std::vector<int>& v) {
    for (std::size_t j = 0; j < u.size(); ++j)  // some j with u_j <= v_j and equality before
      if (u[j] <= v[j] && std::equal(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(j), v.begin()))
        return true;
    return false;
  };
  EXPECT_TRUE(less_as_printed(a, a)) << "a swap without any gain would be repeated for ever";
  EXPECT_TRUE(less_as_printed(a, b) && less_as_printed(b, a));
  EXPECT_FALSE(a < a);
  EXPECT_TRUE(a < b);
}

/// The six angles of a quadrilateral cut along the diagonal ac, in ascending order.
std::vector<Angle<2>> cut_angles(Point2 a, Point2 b, Point2 c, Point2 d) {
  std::vector<Angle<2>> angles{{a, b, c}, {b, c, a}, {c, a, b}, {c, d, a}, {d, a, c}, {a, c, d}};
  std::sort(angles.begin(), angles.end(), [](const auto& p, const auto& q) {
    return compare_angle<2>(Gmp{}, p, q).sign == Sign::negative;
  });
  return angles;
}

/// On one circle both diagonals pass the incircle test and share the least angle, but not the whole angle
/// vector.
TEST(Errata, Item8CocircularTiesDifferInTheAngleVector) {
  const Point2 a{65, 0}, b{52, 39}, c{0, 65}, d{-60, -25};
  EXPECT_EQ(plane()->incircle(a, b, c, d), Sign::zero);
  const auto along_ac = cut_angles(a, b, c, d), along_bd = cut_angles(b, c, d, a);
  const auto compare = [](const Angle<2>& p, const Angle<2>& q) {
    return compare_angle<2>(Gmp{}, p, q).sign;
  };
  EXPECT_EQ(compare(along_ac[0], along_bd[0]), Sign::zero);
  bool differ = false;
  for (std::size_t i = 0; i < 6; ++i) differ |= compare(along_ac[i], along_bd[i]) != Sign::zero;
  EXPECT_TRUE(differ);
}

TEST(Errata, Item11SwappingTheDiagonalOfAnAcutePairLowersTheLeastAngle) {
  const Point2 a{0, 0}, b{1, 0}, c{0.5, 0.8}, d{0.5, -0.8};
  const auto before = cut_angles(a, d, b, c), after = cut_angles(d, b, c, a);  // diagonals ab, cd
  const Angle<2> right{{{{1, 0}}, {{0, 0}}, {{0, 1}}}};
  EXPECT_EQ(compare_angle<2>(Gmp{}, before.back(), right).sign, Sign::negative) << "both triangles are acute";
  EXPECT_EQ(compare_angle<2>(Gmp{}, after.front(), before.front()).sign, Sign::negative);
}

constexpr std::array<Point3, 4> unit_tetrahedron{{{{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}, {{0, 0, 4}}}};
constexpr Point3 inside{{1, 1, 1}};

std::array<Point3, 4> mirrored() {
  auto t = unit_tetrahedron;
  std::swap(t[0], t[1]);
  return t;
}

/// Inside, all b_i are positive; the printed signs say so only where det(1,2,3,4) > 0.
TEST(Errata, Item12ThePrintedConvexitySignsNeedPositiveOrientation) {
  const auto kernel = space();
  const auto printed = [&](std::array<Point3, 4> t, std::size_t i) {
    t[i] = inside;
    return kernel->orient3d(t[0], t[1], t[2], t[3]);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(printed(unit_tetrahedron, i), Sign::positive);
    EXPECT_EQ(printed(mirrored(), i), Sign::negative);
    EXPECT_EQ(barycentric_signs(*kernel, unit_tetrahedron, inside)[i], Sign::positive);
    EXPECT_EQ(barycentric_signs(*kernel, mirrored(), inside)[i], Sign::positive);
  }
}

/// The determinant as printed: columns (1, x, y, [z], w^2), for integer points. By expansion along the first
/// row.
std::int64_t printed_determinant(const std::vector<std::vector<std::int64_t>>& columns) {
  const std::size_t n = columns.size();
  if (n == 1) return columns[0][0];
  std::int64_t sum = 0;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<std::vector<std::int64_t>> minor;
    for (std::size_t k = 0; k < n; ++k)
      if (k != j) minor.emplace_back(columns[k].begin() + 1, columns[k].end());
    sum += (j % 2 == 0 ? 1 : -1) * columns[j][0] * printed_determinant(minor);
  }
  return sum;
}
std::int64_t printed_in_sphere(const auto& points) {
  std::vector<std::vector<std::int64_t>> columns;
  for (const auto& p : points) {
    auto& column = columns.emplace_back(1, 1);
    std::int64_t square = 0;
    for (const double c : p.coordinate) {
      column.push_back(static_cast<std::int64_t>(c));
      square += column.back() * column.back();
    }
    column.push_back(square);
  }
  return printed_determinant(columns);
}

/// Negative inside a positive tetrahedron: -9/16 for the unit one, here four times as large; so the two tests
/// of the section want opposite orientations.
TEST(Errata, Item13ThePrintedInSphereIsNegativeInsideAPositiveTetrahedron) {
  const auto printed = [](const std::array<Point3, 4>& t) {
    return printed_in_sphere(std::array<Point3, 5>{t[0], t[1], t[2], t[3], inside});
  };
  EXPECT_EQ(printed(unit_tetrahedron), -9 * 64);
  EXPECT_EQ(printed(mirrored()), 9 * 64);
  EXPECT_EQ(printed_in_sphere(std::array<Point2, 4>{{{{0, 0}}, {{4, 0}}, {{0, 4}}, {{1, 1}}}}), -3 * 32);
  const auto& t = unit_tetrahedron;
  EXPECT_EQ(space()->insphere(t[0], t[1], t[2], t[3], inside), Sign::positive)
      << "ours is the other way round";
}

/// Connected to the four vertices, a site on an edge gives two flat tetrahedra, one on a face gives one.
TEST(Errata, Item14ASiteOnAnEdgeHasMoreThanFiveNeighbours) {
  const auto kernel = space();
  const auto flat = [&](const Point3& site) {
    const auto b = barycentric_signs(*kernel, unit_tetrahedron, site);
    return std::count(b.begin(), b.end(), Sign::zero);
  };
  EXPECT_EQ(flat(inside), 0);
  EXPECT_EQ(flat({{1, 1, 0}}), 1);
  EXPECT_EQ(flat({{2, 0, 0}}), 2);
}

/// Nine tetrahedra of seven points, six of whose faces fail the in-sphere test, and none of them can be
/// flipped: across each the union is not convex, and the third tetrahedron at the reflex edge is missing.
TEST(Errata, Item16AFaceThatCannotBeFlippedMayFailTheSphereTest) {
  const std::array<Point3, 7> p{
      {{{20, 17, 5}}, {{4, 18, 0}}, {{15, 3, 5}}, {{0, 6, 8}}, {{15, 7, 1}}, {{12, 0, 11}}, {{16, 17, 0}}}};
  using Cell = std::set<std::size_t>;
  const std::set<Cell> mesh{{0, 1, 3, 6}, {0, 2, 4, 5}, {0, 3, 5, 6}, {0, 4, 5, 6}, {1, 2, 3, 4},
                            {1, 2, 3, 5}, {1, 2, 4, 5}, {1, 3, 5, 6}, {1, 4, 5, 6}};
  const auto kernel = space();
  int bad = 0;
  for (const Cell& first : mesh)
    for (const Cell& second : mesh) {
      std::vector<std::size_t> face, apex, other;
      std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                            std::back_inserter(face));
      if (face.size() != 3 || !(first < second)) continue;
      std::set_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(apex));
      std::set_difference(second.begin(), second.end(), first.begin(), first.end(),
                          std::back_inserter(other));
      const std::array<Point3, 4> t{p[face[0]], p[face[1]], p[face[2]], p[apex[0]]};
      const Point3& e = p[other[0]];
      const Sign in = kernel->insphere(t[0], t[1], t[2], t[3], e) * kernel->orient3d(t[0], t[1], t[2], t[3]);
      if (in != Sign::positive) continue;
      ++bad;
      const auto b = barycentric_signs(*kernel, t, e);
      EXPECT_FALSE(is_strictly_convex(b)) << "two to three";
      ASSERT_EQ(std::count(b.begin(), b.begin() + 3, Sign::negative), 1);
      const auto reflex = static_cast<std::size_t>(std::find(b.begin(), b.end(), Sign::negative) - b.begin());
      Cell third{apex[0], other[0], face[0], face[1], face[2]};
      third.erase(face[reflex]);
      EXPECT_FALSE(mesh.count(third)) << "three to two";
    }
  EXPECT_EQ(bad, 6);
}

/// Choosing a sign for an orientation that is zero gives a triangle without area: topologically wrong in the
/// plane.
TEST(Errata, Item17TiesOfOrientationMustNotBeBrokenAtWill) {
  const Point2 a{0, 0}, b{1, 1}, c{2, 2};
  EXPECT_EQ(plane()->orient2d(a, b, c), Sign::zero);
  EXPECT_NE(simulate_orient<2>({a, b, c}).sign, Sign::zero);
}

/// The child abd of a flipped diagonal ac has points in common with both old triangles: two parents.
TEST(Errata, Item18TheDataTreeIsNoTree) {
  const auto kernel = plane();
  const Point2 a{0, 0}, b{4, 0}, c{4, 4}, d{0, 4};
  const auto holds = [&](Point2 u, Point2 v, Point2 w, Point2 q) {
    return kernel->orient2d(u, v, q) == Sign::positive && kernel->orient2d(v, w, q) == Sign::positive &&
           kernel->orient2d(w, u, q) == Sign::positive;
  };
  const Point2 below{2, 1}, above{1, 2};
  EXPECT_TRUE(holds(a, b, d, below) && holds(a, b, c, below));
  EXPECT_TRUE(holds(a, b, d, above) && holds(a, c, d, above));
}

TEST(Errata, Item19TheAngleBetweenNormalsNeedNotBeAcute) {
  const double a1 = 10, a2 = -10, b1 = 0, b2 = 0;
  const double cosine =
      (a1 * a2 + b1 * b2 + 1) / std::sqrt((a1 * a1 + b1 * b1 + 1) * (a2 * a2 + b2 * b2 + 1));
  EXPECT_NEAR(std::acos(cosine) * 180 / std::numbers::pi, 168.58, 0.005);
}

TEST(Errata, Item20ASquareHasTwoDelaunayTriangulations) {
  const auto kernel = plane();
  const Point2 a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};
  EXPECT_EQ(kernel->incircle(a, b, c, d), Sign::zero);
  EXPECT_EQ(kernel->incircle(b, c, d, a), Sign::zero);
}

double dot(Point2 u, Point2 v) { return u[0] * v[0] + u[1] * v[1]; }
double cross(Point2 u, Point2 v) { return u[0] * v[1] - u[1] * v[0]; }
Point2 from(Point2 a, Point2 b) { return {{b[0] - a[0], b[1] - a[1]}}; }
/// Of the angle at b in the triangle a b c, counter-clockwise or not.
double cotangent(Point2 a, Point2 b, Point2 c) {
  return dot(from(b, a), from(b, c)) / std::fabs(cross(from(b, a), from(b, c)));
}

/// n . n' / A = 2 n . n' / |n x n'| needs the normals of one triangle; edges stand for normals, turned by a
/// right angle.
TEST(Errata, Item21TheSecondNumeratorBelongsToTheSecondTriangle) {
  const Point2 v0{0, 0}, before{4, -3}, vi{5, 1}, after{2, 6};  // v_{i-1}, v_i, v_{i+1}
  const Point2 outer_before = from(before, vi), outer_after = from(vi, after), spoke = from(before, v0);
  const double area = std::fabs(cross(from(v0, before), from(v0, vi))) / 2;
  const double left = dot(outer_before, spoke) / area;
  EXPECT_DOUBLE_EQ(left, 2 * dot(outer_before, spoke) / std::fabs(cross(outer_before, spoke)));
  EXPECT_DOUBLE_EQ(left, 2 * cotangent(vi, before, v0));
  EXPECT_GT(std::fabs(left - 2 * dot(outer_after, spoke) / std::fabs(cross(outer_before, spoke))), 0.1);
}

/// cot a + cot b has the sign opposite to incircle's, cot a + cot a has not: one angle is obtuse, and the
/// edge is Delaunay all the same.
TEST(Errata, Item22TheWeightIsTheSumOfBothCotangents) {
  const Point2 v0{0, 0}, vi{4, 0}, right{2, -1}, left{2, 9};
  const double a = cotangent(v0, right, vi), b = cotangent(v0, left, vi);
  EXPECT_EQ(plane()->incircle(v0, vi, left, right), Sign::negative);
  EXPECT_EQ(sign_of(a + b), Sign::positive);
  EXPECT_EQ(sign_of(a + a), Sign::negative);
  const double sine_a = 1 / std::sqrt(1 + a * a), sine_b = 1 / std::sqrt(1 + b * b);
  EXPECT_NEAR(std::sin(std::acos(a * sine_a) + std::acos(b * sine_b)) / (sine_a * sine_b), a + b, 1e-12);
}

/// The bound 1/8 is right; that the series vanishes geometrically from the start is not: rows away from the
/// boundary sum to 1. What proves the bound is (x(1-x) + y(1-y)) / 4, whose discrete Laplacian is -1 exactly.
TEST(Errata, Item23TheBoundOnTheInverseHasAnotherProof) {
  constexpr int n = 8;  // a power of two: nothing is rounded
  constexpr double h = 1.0 / n;
  const auto phi = [](int j, int k) { return (j * h * (1 - j * h) + k * h * (1 - k * h)) / 4; };
  double largest = 0;
  for (int j = 1; j < n; ++j)
    for (int k = 1; k < n; ++k) {
      const double laplacian = phi(j + 1, k) + phi(j - 1, k) + phi(j, k + 1) + phi(j, k - 1) - 4 * phi(j, k);
      EXPECT_EQ(laplacian / (h * h), -1);
      largest = std::max(largest, phi(j, k));
    }
  EXPECT_EQ(largest, 0.125);
  // P s, for s = (1, ..., 1): interior neighbours of a node, a quarter each.
  const auto row_sum = [](int j, int k) {
    const auto interior = [](int i) { return 0 < i && i < n; };
    return (interior(j + 1) + interior(j - 1) + interior(k + 1) + interior(k - 1)) / 4.0;
  };
  EXPECT_EQ(row_sum(n / 2, n / 2), 1);
  EXPECT_EQ(row_sum(1, 1), 0.5);
}

/// A sheared grid cut along its long diagonals is not Delaunay, one of its weights is negative, and yet the
/// inverse of -L has no negative entry: monotone without being Delaunay.
TEST(Errata, Item24MonotoneMeshesNeedNotBeDelaunay) {
  constexpr double shear = 0.05;
  constexpr int side = 3, n = side * side;
  // Cotangent weights of the edges u = (1,0), v = (s,1) and u + v.
  const double along_u = 1 + shear + shear * shear, along_v = 1 + shear, along_diagonal = -shear;
  const Point2 origin{0, 0}, u{1, 0}, v{shear, 1}, w{1 + shear, 1};
  EXPECT_NEAR(along_diagonal, (cotangent(origin, u, w) + cotangent(origin, v, w)) / 2, 1e-15);
  EXPECT_NEAR(along_u, cotangent(origin, w, u), 1e-15);
  EXPECT_NEAR(along_v, cotangent(origin, w, v), 1e-15);
  EXPECT_EQ(plane()->incircle(origin, u, w, v), Sign::positive) << "not Delaunay";

  std::array<std::array<double, 2 * n>, n> m{};  // -L beside the unit matrix
  const auto node = [](int i, int j) { return static_cast<std::size_t>(i * side + j); };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      auto& row = m[node(i, j)];
      row[node(i, j)] = 2 * (along_u + along_v + along_diagonal);
      row[n + node(i, j)] = 1;
      const auto couple = [&](int di, int dj, double weight) {
        for (const int sign : {1, -1}) {
          const int k = i + sign * di, l = j + sign * dj;
          if (0 <= k && k < side && 0 <= l && l < side) row[node(k, l)] -= weight;
        }
      };
      couple(1, 0, along_u);
      couple(0, 1, along_v);
      couple(1, 1, along_diagonal);
    }
  for (std::size_t i = 0; i < n; ++i) {  // Gauss and Jordan; the matrix is positive definite
    const double pivot = m[i][i];
    for (double& x : m[i]) x /= pivot;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double factor = m[k][i];
      for (std::size_t j = 0; j < 2 * n; ++j) m[k][j] -= factor * m[i][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = n; j < 2 * n; ++j)
      EXPECT_GT(m[i][j], 0.001) << "entries are far from rounding errors";
}

}  // namespace
}  // namespace tribunal::laws
