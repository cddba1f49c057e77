// Triangulations to start flipping from: valid, and as bad as can be, or nearly good.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/flips/sites.hpp"
#include "algorithms/mesh/edge_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

enum class Start : std::uint8_t {
  sweep,   ///< from left to right, each site joined to what it sees of the hull
  fan,     ///< all sites joined to the leftmost one as far as they see it, in order around it
  halves,  ///< in spatial order: halved again and again, the hulls of halves joined
};

/// Triangulates distinct sites, not all collinear, without a circle test. Triangles are counter-clockwise and
/// cover the convex hull. O(n log n). Abandons (inconsistent_predicate) where signs make no sense.
std::vector<Triangle> start_triangulation(const Sites& sites, std::span<const Index> vertices, Start start);

/// Tries `attempts` edges drawn at random, and flips those whose quadrilaterals are strictly convex. Fixed
/// edges stay (by edge, empty where there are none). Returns the number of flips.
std::uint64_t flip_at_random(const Sites& sites, EdgeMesh& mesh, std::uint64_t attempts, std::uint64_t seed,
                             std::span<const char> fixed = {});

}  // namespace tribunal
