// Watson's insertion: a flat list of circles, no adjacency.
#pragma once

#include "algorithms/algorithm.hpp"

namespace tribunal {

/// Watson 1981: scan every circle for conflicts, delete those triangles, join the site to the edges that
/// remain. A triangle whose circle lies left of all sites still to come is retired, so that x order scans
/// O(sqrt n) circles per site on uniform data; random order scans nearly all of them, O(n^2).
Triangulation watson(const PlanarProblem& problem);

inline constexpr PlanarAlgorithm watson_algorithm{
    .about = {.name = "watson",
              .dimension = 2,
              .cites = "Watson 1981",
              .summary = "incremental Delaunay: scan a flat list of circles, cancel doubled edges"},
    .run = watson,
};

}  // namespace tribunal
