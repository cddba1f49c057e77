// Which of two angles is larger, without trigonometry.
#pragma once

#include "predicates/decision.hpp"
#include "predicates/formulas/squared_distance.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace tribunal {

/// |u| |v| times the cosine of the angle at p1 from p0 to p2; u and v are its legs. Positive when it is
/// acute.
template <int D>
struct Cosine {
  static constexpr int dimension = D, points = 3;
  static constexpr auto determinant(const auto& p) {
    const auto ux = p[0][0] - p[1][0], uy = p[0][1] - p[1][1];
    const auto vx = p[2][0] - p[1][0], vy = p[2][1] - p[1][1];
    if constexpr (D == 2) {
      return ux * vx + uy * vy;
    } else {
      const auto uz = p[0][2] - p[1][2], vz = p[2][2] - p[1][2];
      return ux * vx + uy * vy + uz * vz;
    }
  }
};

/// The difference of the squared cosines of the angles p0 p1 p2 and p3 p4 p5, times the squared lengths of
/// their four legs: of degree 8.
template <int D>
struct CompareCosineSquares {
  static constexpr int dimension = D, points = 6;
  static constexpr auto determinant(const auto& p) {
    const auto first = Cosine<D>::determinant(std::array{p[0], p[1], p[2]});
    const auto second = Cosine<D>::determinant(std::array{p[3], p[4], p[5]});
    const auto first_legs = squared_distance<D>(p[0], p[1]) * squared_distance<D>(p[2], p[1]);
    const auto second_legs = squared_distance<D>(p[3], p[4]) * squared_distance<D>(p[5], p[4]);
    return first * first * second_legs - second * second * first_legs;
  }
};

/// An angle in [0, pi]: at the second point, between the first and the third, both distinct from it.
template <int D>
using Angle = std::array<Point<D>, 3>;

/// Positive when the angle p is larger than q. Exact with an exact backend, which is asked for two signs, and
/// for a third where they agree; the stage is the costliest of them.
///
/// The cosine falls on [0, pi]. Where the cosines of p and q differ in sign that decides; where they agree,
/// their squares do, the other way round below zero.
template <int D, class B>
Decision compare_angle(const B& backend, const Angle<D>& p, const Angle<D>& q) {
  assert(!(p[0] == p[1]) && !(p[2] == p[1]) && !(q[0] == q[1]) && !(q[2] == q[1]));
  const Decision first = backend.template decide<Cosine<D>>(p),
                 second = backend.template decide<Cosine<D>>(q);
  const Stage signs = std::max(first.stage, second.stage);
  if (first.sign != second.sign) return {first.sign < second.sign ? Sign::positive : Sign::negative, signs};
  if (first.sign == Sign::zero) return {Sign::zero, signs};
  const Decision squares =
      backend.template decide<CompareCosineSquares<D>>({p[0], p[1], p[2], q[0], q[1], q[2]});
  return {-(first.sign * squares.sign), std::max(signs, squares.stage)};
}

}  // namespace tribunal
