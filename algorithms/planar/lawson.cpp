// Lawson's global edge swapping (1977), Barth section 3.3d: from any triangulation, flip edges that violate
// the circle test until none does. Quadratic in the worst case, whatever the order of the flips.
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/parameters.hpp"
#include "algorithms/planar/listed.hpp"

namespace tribunal {
namespace {

Triangulation lawson(const PlanarProblem& problem) {
  return triangulate_by_flips<DelaunayCriterion>(problem, flip_options(problem.settings));
}

}  // namespace

constinit const PlanarAlgorithm lawson_algorithm{
    .about = {.name = "lawson",
              .dimension = 2,
              .cites = "Lawson 1977; Barth section 3.3d",
              .summary = "any triangulation, then flips until all circles are empty",
              .incremental = false},
    .parameters = flip_parameters,
    .run = lawson,
};

}  // namespace tribunal
