// Breaking ties of the in-sphere test by raising points a little over the paraboloid, each by its own amount.
#pragma once

#include "predicates/decision.hpp"
#include "predicates/point.hpp"
#include "predicates/symbolic/rank.hpp"

#include <array>
#include <cstddef>

namespace tribunal {

// Devillers and Teillaud 2011. Lift each point p to (p, |p|^2 + e(p)), where the e(p) > 0 are infinitesimal
// and that of a point is infinitely larger than those of all points of lesser rank. Points keep their places:
// orientations are true and only the lift is perturbed. Whatever polynomial in the lifts vanishes now gets
// the sign of its first nonzero coefficient, in the order of falling ranks.
//
// The in-sphere determinant is, in our convention, minus the determinant with rows (1, p, |p|^2) of n = D + 2
// points. It is linear in the lifts. That of point i, counted from 0, has there the cofactor (-1)^(i + n - 1)
// times the orientation of the others in their order; so e(p_i) is worth (-1)^(i + n) of it. Two equal points
// would have equal lifts: then it is zero identically.
//
// Distinct points on a circle have no three on a line: there the point of highest rank decides at once. On a
// sphere the others may be coplanar, and the next one is asked. What remains zero is D + 2 points of a
// hyperplane.

/// The sign of the perturbed in-sphere test of D + 2 points whose true one is zero. `orient` answers, as a
/// Sign, for arrays of D + 1 points, exactly.
template <int D, class Orient>
Decision break_in_sphere_tie(const std::array<Point<D>, D + 2>& points, Orient orient) {
  const auto ranked = rank<D>(points);
  if (ranked.parity == Sign::zero) return {Sign::zero, Stage::symbolic};
  for (std::size_t k = points.size(); k-- > 0;) {
    const std::size_t raised = ranked.order[k];
    std::array<Point<D>, D + 1> others{};
    for (std::size_t i = 0, j = 0; i < points.size(); ++i)
      if (i != raised) others[j++] = points[i];
    const Sign orientation = orient(others);
    if (orientation != Sign::zero)
      return {(raised + points.size()) % 2 == 0 ? orientation : -orientation, Stage::symbolic};
  }
  return {Sign::zero, Stage::symbolic};
}

}  // namespace tribunal
