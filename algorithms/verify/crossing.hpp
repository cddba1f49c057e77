// Finds where a mesh that fails elsewhere overlaps itself.
#pragma once

#include "algorithms/verify/triangles.hpp"

namespace tribunal::verify {

/// Names one place where two edges cross, or a vertex lies inside an edge or a triangle; none when there is
/// no such place. Triangles without area have no part in it. O(t log t): a sweep over the plane that stops at
/// its first find. With `lone_sites`, a site in no triangle that lies inside an edge or triangle is such a
/// place too.
void find_crossing(std::span<const Point2> points, const Sites& sites,
                   std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses, FaultList& faults,
                   bool lone_sites = false);

}  // namespace tribunal::verify
