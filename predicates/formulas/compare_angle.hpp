// Which of two angles is larger, without trigonometry.
#pragma once

#include "predicates/decision.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/squared_distance.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

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

/// The sine of the difference of two planar angles, times the lengths of their four legs. Each is counted
/// from its last leg, p2 or p5, counter-clockwise to its first: of degree 4, no more than the circle test.
struct SineOfDifference {
  static constexpr int dimension = 2, points = 6;
  static constexpr auto determinant(const auto& p) {
    const auto ux = p[0][0] - p[1][0], uy = p[0][1] - p[1][1], vx = p[2][0] - p[1][0], vy = p[2][1] - p[1][1];
    const auto rx = p[3][0] - p[4][0], ry = p[3][1] - p[4][1], sx = p[5][0] - p[4][0], sy = p[5][1] - p[4][1];
    return (vx * uy - vy * ux) * (rx * sx + ry * sy) - (sx * ry - sy * rx) * (ux * vx + uy * vy);
  }
};

/// An angle in [0, pi]: at the second point, between the first and the third, both distinct from it.
template <int D>
using Angle = std::array<Point<D>, 3>;

namespace detail {

/// The cosine falls on [0, pi]: what its sign at p and q tells of them, zero where it is the same.
struct ComparedCosineSigns {
  Sign at_p;
  Decision decision;
};
template <int D, class B>
ComparedCosineSigns compare_cosine_signs(const B& backend, const Angle<D>& p, const Angle<D>& q) {
  const Decision first = backend.template decide<Cosine<D>>(p),
                 second = backend.template decide<Cosine<D>>(q);
  const int order = static_cast<int>(second.sign) - static_cast<int>(first.sign);
  return {first.sign, {sign_of(order), std::max(first.stage, second.stage)}};
}

/// Where the cosines agree in sign, their squares decide, the other way round below zero.
template <int D, class B>
Decision compare_by_cosines(const B& backend, const Angle<D>& p, const Angle<D>& q) {
  const ComparedCosineSigns signs = compare_cosine_signs<D>(backend, p, q);
  if (signs.decision.sign != Sign::zero || signs.at_p == Sign::zero) return signs.decision;
  const Decision squares =
      backend.template decide<CompareCosineSquares<D>>({p[0], p[1], p[2], q[0], q[1], q[2]});
  return {-(signs.at_p * squares.sign), std::max(signs.decision.stage, squares.stage)};
}

/// The sine of the difference has its sign, but for angles of 0 and pi. Those cosines tell apart.
template <class B>
Decision compare_by_sine(const B& backend, Angle<2> p, Angle<2> q) {
  const Decision first = backend.template decide<Orient<2>>({p[1], p[2], p[0]}),
                 second = backend.template decide<Orient<2>>({q[1], q[2], q[0]});
  const Stage turns = std::max(first.stage, second.stage);
  if (first.sign == Sign::zero && second.sign == Sign::zero) {
    const Decision decision = compare_cosine_signs<2>(backend, p, q).decision;
    return {decision.sign, std::max(turns, decision.stage)};
  }
  if (first.sign == Sign::negative) std::swap(p[0], p[2]);
  if (second.sign == Sign::negative) std::swap(q[0], q[2]);
  const Decision sine = backend.template decide<SineOfDifference>({p[0], p[1], p[2], q[0], q[1], q[2]});
  return {sine.sign, std::max(turns, sine.stage)};
}

}  // namespace detail

/// Positive when the angle p is larger than q. Exact with an exact backend, which is asked for two or three
/// signs; the stage is the costliest of them. Of degree 4 in the plane, 8 in space, where angles have no
/// sense of rotation.
template <int D, class B>
Decision compare_angle(const B& backend, const Angle<D>& p, const Angle<D>& q) {
  assert(!(p[0] == p[1]) && !(p[2] == p[1]) && !(q[0] == q[1]) && !(q[2] == q[1]));
  if constexpr (D == 2)
    return detail::compare_by_sine(backend, p, q);
  else
    return detail::compare_by_cosines<D>(backend, p, q);
}

}  // namespace tribunal
