// Signs that are never zero for distinct points: every coordinate is perturbed by its own infinitesimal.
#pragma once

#include "predicates/arithmetic/big_integer.hpp"
#include "predicates/arithmetic/exponent_window.hpp"
#include "predicates/decision.hpp"
#include "predicates/point.hpp"
#include "predicates/symbolic/rank.hpp"

#include <array>
#include <cstddef>

namespace tribunal {

// Edelsbrunner and Muecke 1990. Coordinate j of point p becomes p[j] + e(p, j), where each e is positive and
// smaller than every product of larger ones. In the order of falling e: the points of higher rank first; of
// one point the last coordinate first. In-sphere tests have the lift |p|^2 for one more coordinate, perturbed
// by itself.
//
// A determinant of these coordinates and a column of ones is a polynomial in the e, linear in each. The
// coefficient of a product of some e's is the determinant in which their entries' rows are replaced by unit
// rows. Without any it is the true determinant; as soon as an e is taken from every column but that of ones
// it is +-1. So the sign is that of the first nonzero coefficient, in the order of falling products: that is
// the order of subsets in which those without the smallest e come first, among them those without the second
// smallest, and so on.

namespace detail {

/// Rows of points in ascending rank; column 0 holds ones.
template <std::size_t N>
using IntegerMatrix = std::array<std::array<BigInteger, N>, N>;

/// Determinant by expansion along the first column.
template <std::size_t N>
BigInteger determinant(const IntegerMatrix<N>& m) {
  if constexpr (N == 1) {
    return m[0][0];
  } else {
    BigInteger sum{0};
    for (std::size_t i = 0; i < N; ++i) {
      if (sign_of(m[i][0]) == Sign::zero) continue;
      IntegerMatrix<N - 1> minor;
      for (std::size_t k = 0; k < N; ++k)
        if (k != i)
          for (std::size_t j = 1; j < N; ++j) minor[k < i ? k : k - 1][j - 1] = m[k][j];
      const BigInteger term = m[i][0] * determinant(minor);
      sum = i % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
  }
}

/// The sign of the perturbed determinant when the infinitesimals from the one numbered `next` on, in the
/// order of rising size, may still be taken; rows and columns that have been are marked. Calls itself N (N -
/// 1) deep at most.
template <std::size_t N>
Sign perturbed_sign(const IntegerMatrix<N>& m, std::size_t next, unsigned rows, unsigned columns) {
  if (next == N * (N - 1)) return sign_of(determinant(m));
  const std::size_t row = next / (N - 1), column = 1 + next % (N - 1);
  const Sign without = perturbed_sign(m, next + 1, rows, columns);
  if (without != Sign::zero || (rows >> row & 1) != 0 || (columns >> column & 1) != 0) return without;
  IntegerMatrix<N> unit = m;
  unit[row].fill(BigInteger{0});
  unit[row][column] = BigInteger{1};
  return perturbed_sign(unit, next + 1, rows | 1U << row, columns | 1U << column);
}

/// The sign for D + 1 points, or D + 2 with a column of lifts; zero when two of them are equal.
template <int D, std::size_t N>
Decision simulate(const std::array<Point<D>, N>& points) {
  const auto ranked = rank<D>(points);
  if (ranked.parity == Sign::zero) return {Sign::zero, Stage::symbolic};
  const ExponentWindow window = exponent_window(points);
  IntegerMatrix<N> m;
  for (std::size_t i = 0; i < N; ++i) {
    const Point<D>& p = points[ranked.order[i]];
    BigInteger lift{0};
    m[i][0] = BigInteger{1};
    for (std::size_t axis = 0; axis < D; ++axis) {
      const BigInteger c = scaled_integer(p[axis], window.lowest);
      m[i][axis + 1] = c;
      lift = lift + c * c;
    }
    if constexpr (N == D + 2) m[i][D + 1] = lift;
  }
  const Sign exact = sign_of(determinant(m));
  if (exact != Sign::zero) return {exact * ranked.parity, Stage::exact};
  return {perturbed_sign(m, 0, 0, 0) * ranked.parity, Stage::symbolic};
}

}  // namespace detail

/// Orientation, as Orient<D>, of points of which no D + 1 are ever in a hyperplane: never zero unless two are
/// equal. For any finite doubles; costs microseconds, so ask an exact kernel first and this about its zeros.
template <int D>
Decision simulate_orient(const std::array<Point<D>, D + 1>& points) {
  return detail::simulate<D>(points);
}

/// The in-sphere test, as InSphere<D>, of points of which no D + 2 are ever on a sphere. The lifts are
/// perturbed apart from the places, so what it describes is a regular triangulation infinitesimally close to
/// the Delaunay triangulation; orientations that go with it are those of simulate_orient.
template <int D>
Decision simulate_in_sphere(const std::array<Point<D>, D + 2>& points) {
  const Decision above = detail::simulate<D>(points);
  return {-above.sign, above.stage};
}

}  // namespace tribunal
