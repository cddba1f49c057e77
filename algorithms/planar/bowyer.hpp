// Bowyer's insertion: walk to one conflicting triangle, flood the connected cavity, star it from the new
// site.
#pragma once

#include "algorithms/algorithm.hpp"

namespace tribunal {

/// Bowyer 1981, with adjacency. O(n) retriangulation and O(n^{3/2}) walking expected in random order.
Triangulation bowyer(const PlanarProblem& problem);

inline constexpr PlanarAlgorithm bowyer_algorithm{
    .about = {.name = "bowyer",
              .dimension = 2,
              .cites = "Bowyer 1981",
              .summary = "incremental Delaunay: walk to a conflict, flood the cavity, re-star it"},
    .run = bowyer,
};

}  // namespace tribunal
