// Green and Sibson's insertion: split the triangle that holds the site, then flip until all circles are
// empty.
#pragma once

#include "algorithms/algorithm.hpp"

namespace tribunal {

/// Green and Sibson 1977 with the history DAG of Guibas, Knuth and Sharir 1992 (Barth, section 3.3c):
/// expected O(n log n) in random order.
Triangulation green_sibson(const PlanarProblem& problem);

inline constexpr PlanarAlgorithm green_sibson_algorithm{
    .about = {.name = "green-sibson",
              .dimension = 2,
              .cites = "Green, Sibson 1977; Guibas, Knuth, Sharir 1992",
              .summary = "incremental Delaunay: split, flip suspects, locate through the history DAG"},
    .run = green_sibson,
};

}  // namespace tribunal
