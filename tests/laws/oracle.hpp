// An exact oracle that shares no code with the predicates: Boost's integers, and the homogeneous determinants
// by Leibniz's sum over permutations.
#pragma once

#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <span>

namespace tribunal::oracle {

/// Sign of the determinant with rows (1, x, y, [z]) of D + 1 points, D = 2 or 3; any finite doubles.
template <int D>
Sign orient(std::span<const Point<D>> points);

/// Minus the sign of the determinant with rows (1, x, y, [z], |p|^2) of D + 2 points: that one is positive
/// where the last point lies above the lifted plane of positively oriented ones, which is outside.
template <int D>
Sign in_sphere(std::span<const Point<D>> points);

/// Sign of |ab|^2 - |cd|^2.
Sign compare_length(Point2 a, Point2 b, Point2 c, Point2 d);

/// Sign of the difference of two angles in [0, pi], each at its second point, by the squares of their
/// cosines.
Sign compare_angle(const std::array<Point2, 3>& p, const std::array<Point2, 3>& q);

}  // namespace tribunal::oracle
