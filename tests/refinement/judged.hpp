// What the exact checker and rational numbers say of a refined mesh.
#pragma once

#include "algorithms/refinement/steiner_mesh.hpp"
#include "algorithms/verify/verify.hpp"

#include <string>

namespace tribunal::refinement {

/// The faults of the mesh over its own subsegments, line by line; empty where there are none.
std::string faults_of(const Refined& refined, std::span<const Point2> holes, verify::Domain domain);

/// Expects the subsegments of each segment to be a path between its ends, of points that are at most
/// three doubles away from it in x and in y, as doubles lie at its coarser end.
void expect_paths(const Refined& refined, std::span<const Point2> points, std::span<const Edge> segments);

}  // namespace tribunal::refinement
