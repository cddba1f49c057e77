// The truth about small integer lattices: 64-bit integers and cofactors, which share no code with the
// formulas.
#pragma once

#include "predicates/kernel.hpp"
#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace tribunal::lattice {

/// Determinant by expansion along the first column.
template <std::size_t N>
std::int64_t determinant(const std::array<std::array<std::int64_t, N>, N>& m) {
  if constexpr (N == 1) {
    return m[0][0];
  } else {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
      if (m[i][0] == 0) continue;
      std::array<std::array<std::int64_t, N - 1>, N - 1> minor;
      for (std::size_t k = 0; k < N; ++k)
        if (k != i)
          for (std::size_t j = 1; j < N; ++j) minor[k < i ? k : k - 1][j - 1] = m[k][j];
      sum += (i % 2 == 0 ? 1 : -1) * m[i][0] * determinant(minor);
    }
    return sum;
  }
}

/// Row (1, x, y, [z]) of a point for an orientation of D + 1 of them; with |p|^2 behind it for an in-sphere
/// test of D + 2.
template <int D, std::size_t N>
std::array<std::int64_t, N> row_of(const Point<D>& p) {
  static_assert(N == D + 1 || N == D + 2);
  std::array<std::int64_t, N> row{1};
  for (int axis = 0; axis < D; ++axis) {
    row[axis + 1] = static_cast<std::int64_t>(p[axis]);
    if constexpr (N == D + 2) row[D + 1] += row[axis + 1] * row[axis + 1];
  }
  return row;
}

/// The coefficients of the last row in the determinant of N rows: with them the truth for all last points is
/// a dot product each.
template <std::size_t N>
std::array<std::int64_t, N> cofactors(const std::array<std::array<std::int64_t, N>, N - 1>& rows) {
  std::array<std::int64_t, N> result;
  for (std::size_t j = 0; j < N; ++j) {
    std::array<std::array<std::int64_t, N - 1>, N - 1> minor;
    for (std::size_t i = 0; i < N - 1; ++i)
      for (std::size_t k = 0; k < N; ++k)
        if (k != j) minor[i][k < j ? k : k - 1] = rows[i][k];
    result[j] = ((N - 1 + j) % 2 == 0 ? 1 : -1) * determinant(minor);
  }
  return result;
}

/// All points with coordinates 0, 1, ..., size - 1.
template <int D>
std::vector<Point<D>> lattice(int size) {
  std::vector<Point<D>> points{Point<D>{}};
  for (int axis = 0; axis < D; ++axis) {
    std::vector<Point<D>> extended;
    for (const auto& p : points)
      for (int x = 0; x < size; ++x) {
        extended.push_back(p);
        extended.back()[axis] = x;
      }
    points = std::move(extended);
  }
  return points;
}

template <int D>
using Kernel = std::conditional_t<D == 2, Kernel2, Kernel3>;

/// Orientation of D + 1 points, or the in-sphere test of D + 2.
inline Sign ask(const Kernel2& k, const std::array<Point2, 3>& p) { return k.orient2d(p[0], p[1], p[2]); }
inline Sign ask(const Kernel2& k, const std::array<Point2, 4>& p) {
  return k.incircle(p[0], p[1], p[2], p[3]);
}
inline Sign ask(const Kernel3& k, const std::array<Point3, 4>& p) {
  return k.orient3d(p[0], p[1], p[2], p[3]);
}
inline Sign ask(const Kernel3& k, const std::array<Point3, 5>& p) {
  return k.insphere(p[0], p[1], p[2], p[3], p[4]);
}

struct Sweep {
  std::uint64_t queries = 0, zeros = 0, wrong = 0;
  std::string first_wrong;  ///< its points as text
};

/// Asks the kernel about every N-tuple of the points, in every order and with repetitions, against the truth.
template <std::size_t N, int D>
Sweep sweep(const std::vector<Point<D>>& points, const Kernel<D>& kernel) {
  Sweep result;
  std::vector<std::array<std::int64_t, N>> rows;
  for (const auto& p : points) rows.push_back(row_of<D, N>(p));
  std::uint64_t leading = 1;
  for (std::size_t i = 0; i + 1 < N; ++i) leading *= points.size();
  std::array<Point<D>, N> query{};
  std::array<std::array<std::int64_t, N>, N - 1> first_rows{};
  for (std::uint64_t code = 0; code < leading; ++code) {
    std::uint64_t rest = code;
    for (std::size_t i = 0; i + 1 < N; ++i, rest /= points.size()) {
      query[i] = points[rest % points.size()];
      first_rows[i] = rows[rest % points.size()];
    }
    const auto coefficients = cofactors<N>(first_rows);
    for (std::size_t last = 0; last < points.size(); ++last) {
      std::int64_t value = 0;
      for (std::size_t j = 0; j < N; ++j) value += coefficients[j] * rows[last][j];
      // Above the lifted plane of positively oriented points is outside.
      const Sign truth = N == D + 2 ? -sign_of(value) : sign_of(value);
      query[N - 1] = points[last];
      const bool right = ask(kernel, query) == truth;
      ++result.queries;
      result.zeros += truth == Sign::zero;
      result.wrong += !right;
      if (right || !result.first_wrong.empty()) continue;
      for (const auto& p : query)
        for (const double c : p.coordinate) result.first_wrong += std::to_string(static_cast<int>(c)) + " ";
    }
  }
  return result;
}

}  // namespace tribunal::lattice
