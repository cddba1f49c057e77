// An outsider's triangles as the checker wants them.
#pragma once

#include "algorithms/triangulation.hpp"
#include "predicates/point.hpp"

#include <span>
#include <vector>

namespace tribunal::bench {

/// What outsiders may choose freely is chosen for them: a corner at a repeated position becomes its first
/// copy, clockwise triangles are turned round, by exact signs, and the order is that of canonical(). Corners
/// out of range, repeated corners and flat triangles stay as they are, for the checker to find. O((n + t) log
/// n).
std::vector<Triangle> normalise(std::span<const Point2> points, std::vector<Triangle> triangles);

}  // namespace tribunal::bench
