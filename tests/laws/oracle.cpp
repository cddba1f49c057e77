#include "tests/laws/oracle.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tribunal::oracle {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rows = std::vector<std::vector<Integer>>;

/// x * 2^shift, an integer.
Integer scaled(double x, int shift) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  Integer result = static_cast<long long>(std::ldexp(fraction, 53));
  const int up = exponent - 53 + shift;
  if (up >= 0) {
    result <<= up;
  } else {
    result >>= -up;
  }
  return result;
}

/// Rows (1, x, y, [z]), all coordinates multiplied by one power of two.
template <int D>
Rows homogeneous_rows(std::span<const Point<D>> points) {
  int lowest = 2000;  // binary exponent of the smallest coordinate: no set bit is 53 places below it
  for (const auto& p : points)
    for (const double c : p.coordinate)
      if (c != 0) lowest = std::min(lowest, std::ilogb(c));
  Rows rows;
  for (const auto& p : points) {
    rows.push_back({Integer(1)});
    for (const double c : p.coordinate) rows.back().push_back(scaled(c, 53 - lowest));
  }
  return rows;
}

Sign leibniz_sign(const Rows& matrix) {
  std::vector<std::size_t> permutation(matrix.size());
  std::iota(permutation.begin(), permutation.end(), std::size_t{0});
  Integer determinant = 0;
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < permutation.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) inversions += permutation[j] > permutation[i];
    Integer term = inversions % 2 == 0 ? 1 : -1;
    for (std::size_t i = 0; i < permutation.size(); ++i) term *= matrix[i][permutation[i]];
    determinant += term;
  } while (std::next_permutation(permutation.begin(), permutation.end()));
  return static_cast<Sign>(determinant.sign());
}

Integer squared_distance(const std::vector<Integer>& a, const std::vector<Integer>& b) {
  const Integer x = a[1] - b[1], y = a[2] - b[2];
  return x * x + y * y;
}

/// The cosine of the angle at rows[i + 1] as an exact fraction: its square with its sign, over `legs`.
struct SignedSquare {
  Integer numerator, legs;
};
SignedSquare signed_squared_cosine(const Rows& rows, std::size_t i) {
  const auto &a = rows[i], &apex = rows[i + 1], &b = rows[i + 2];
  const Integer dot = (a[1] - apex[1]) * (b[1] - apex[1]) + (a[2] - apex[2]) * (b[2] - apex[2]);
  return {dot * abs(dot), squared_distance(a, apex) * squared_distance(b, apex)};
}

}  // namespace

Sign compare_length(Point2 a, Point2 b, Point2 c, Point2 d) {
  const Rows rows = homogeneous_rows<2>(std::array{a, b, c, d});
  const Integer difference = squared_distance(rows[0], rows[1]) - squared_distance(rows[2], rows[3]);
  return static_cast<Sign>(difference.sign());
}

Sign compare_angle(const std::array<Point2, 3>& p, const std::array<Point2, 3>& q) {
  const Rows rows = homogeneous_rows<2>(std::array{p[0], p[1], p[2], q[0], q[1], q[2]});
  const SignedSquare first = signed_squared_cosine(rows, 0), second = signed_squared_cosine(rows, 3);
  const Integer difference = second.numerator * first.legs - first.numerator * second.legs;
  return static_cast<Sign>(difference.sign());
}

template <int D>
Sign orient(std::span<const Point<D>> points) {
  return leibniz_sign(homogeneous_rows(points));
}

template <int D>
Sign in_sphere(std::span<const Point<D>> points) {
  Rows rows = homogeneous_rows(points);
  for (auto& row : rows) {
    Integer lift = 0;
    for (std::size_t axis = 1; axis <= D; ++axis) lift += row[axis] * row[axis];
    row.push_back(lift);
  }
  return -leibniz_sign(rows);
}

template Sign orient<2>(std::span<const Point2>);
template Sign orient<3>(std::span<const Point3>);
template Sign in_sphere<2>(std::span<const Point2>);
template Sign in_sphere<3>(std::span<const Point3>);

}  // namespace tribunal::oracle
