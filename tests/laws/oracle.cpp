#include "tests/laws/oracle.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
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

}  // namespace

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
