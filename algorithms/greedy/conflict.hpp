// Whether two segments may both be edges of one triangulation.
#pragma once

#include "algorithms/algorithm.hpp"

namespace tribunal {

/// True when two different segments between sites meet in more than a common end: they cross, overlap, or an
/// end of one lies inside the other. O(1), at most four orientations; boxes that are apart need none.
bool segments_conflict(const PlanarProblem& problem, const Edge& e, const Edge& f);

}  // namespace tribunal
