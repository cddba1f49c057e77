// The checker's own exact signs, for all finite doubles: a certified floating-point filter, then GMP
// integers.
#pragma once

#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <span>

namespace tribunal::verify {

/// Positive when a, b, c turn counter-clockwise, zero when they are collinear.
Sign orientation(Point2 a, Point2 b, Point2 c);

/// For a counter-clockwise triangle a, u, v and a clockwise one b, u, v, which share the edge uv: the sign of
/// sin(alpha + beta), alpha and beta being their angles at a and b. Negative when each apex is strictly
/// inside the circle of the other triangle, zero when the four points are cocircular, positive when the edge
/// is locally Delaunay.
///
/// Two opposite angles of a quadrilateral inscribed in a circle add up to pi, and grow as their apex moves
/// inwards, so this is the empty-circle test without the lifted determinant (Cline and Renka 1984). As a
/// polynomial it equals minus the incircle determinant of a, u, v; b.
Sign opposite_angles(Point2 a, Point2 b, Point2 u, Point2 v);

/// Sign of the area enclosed by closed polygons, given as their directed edges in any order: positive when
/// counter-clockwise. No filter: for boundaries that are already known to be wrong.
Sign enclosed_area(std::span<const std::array<Point2, 2>> edges);

}  // namespace tribunal::verify
