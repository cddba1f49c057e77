// A triangulation to start flipping from whose triangles lie about where they will end.
#pragma once

#include "algorithms/flips/sites.hpp"

#include <span>
#include <vector>

namespace tribunal {

/// Sites in an order that keeps neighbours together, and triangles that name them by their places in it.
struct Halved {
  std::vector<Index> order;
  std::vector<Triangle> triangles;
};

/// Triangulates distinct sites, not all collinear: halves them across the longer side of their box, both
/// halves likewise, and joins the convex hulls of what comes back by a strip of triangles between their
/// common tangents, as Guibas and Stolfi (1985) do, who repair what lies behind the strip at once. On uniform
/// sites flips to the Delaunay triangulation are then O(n) expected: the few long edges at a joint of m sites
/// cross O(sqrt m) others. O(n log n) where hulls are small. Abandons (inconsistent_predicate) where signs
/// make no sense.
Halved triangulate_by_halves(const Sites& sites, std::span<const Index> vertices);

}  // namespace tribunal
