// The order that symbolic perturbations follow.
#pragma once

#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace tribunal {

/// Some points in ascending lexicographic order of their coordinates, their rank. A point has the same rank
/// in every query, in every order of insertion and in every permutation of the input, as an index has not;
/// and a kernel, which sees points, knows it.
template <int D, std::size_t N>
struct Ranked {
  std::array<std::size_t, N> order;  ///< order[0] is the index of the least point
  Sign parity;                       ///< of the permutation; zero when two points are equal
};

/// O(N^2), N being at most D + 2.
template <int D, std::size_t N>
constexpr Ranked<D, N> rank(const std::array<Point<D>, N>& points) {
  Ranked<D, N> ranked{{}, Sign::positive};
  std::iota(ranked.order.begin(), ranked.order.end(), std::size_t{0});
  for (std::size_t i = 1; i < N; ++i)
    for (std::size_t j = i; j > 0; --j) {
      const Point<D>&here = points[ranked.order[j]], &before = points[ranked.order[j - 1]];
      if (here == before) ranked.parity = Sign::zero;
      if (!(here < before)) break;
      std::swap(ranked.order[j], ranked.order[j - 1]);
      ranked.parity = -ranked.parity;
    }
  return ranked;
}

}  // namespace tribunal
