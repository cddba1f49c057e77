// The globally smallest largest angle, by inserting edges that break the largest one.
#pragma once

#include "algorithms/flips/sites.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

/// What an edge insertion costs, in operations.
struct EdgeInsertionCounts {
  std::uint64_t insertions = 0;  ///< edges that made the triangulation better
  std::uint64_t attempts = 0;    ///< edges tried
  std::uint64_t candidates = 0;  ///< vertices looked at for the far end of an edge
  std::uint64_t crossings = 0;   ///< edges that tried edges cross
  std::uint64_t ears = 0;        ///< corners looked at for an ear to cut
};

struct EdgeInsertionResult {
  std::vector<Triangle> triangles;
  EdgeInsertionCounts counts;
};

/// Edge insertion (Edelsbrunner, Tan, Waupotitsch 1992): of all triangulations of the vertices that the
/// counter-clockwise `triangles` triangulate, one whose largest angle is smallest.
///
/// While there is an edge from the apex of a largest angle, across the side opposite, such that ears with
/// smaller angles alone fill the two polygons that it opens, it is inserted. Where ears do not fill them, no
/// triangulation with a smaller largest angle has that edge, so that it is never tried again. Angles are
/// compared exactly; a tie is no improvement. O(n^2) edges are tried at most, each in time proportional to
/// its crossings: O(n^3). Abandons (inconsistent_predicate) where signs make no sense.
EdgeInsertionResult insert_edges_for_min_max_angle(const Sites& sites, std::span<const Triangle> triangles);

}  // namespace tribunal
