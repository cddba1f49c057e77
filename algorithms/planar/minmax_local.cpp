// Locally optimal MinMax triangulation, Barth section 3.4: Lawson's flips, where they make the largest of the
// six angles smaller. Where it ends depends on where it starts.
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/flips/parameters.hpp"
#include "algorithms/planar/listed.hpp"

namespace tribunal {
namespace {

Triangulation minmax_local(const PlanarProblem& problem) {
  return triangulate_by_flips<MinMaxCriterion>(problem, flip_options(problem.settings));
}

}  // namespace

constinit const PlanarAlgorithm minmax_local_algorithm{
    .about = {.name = "minmax-local",
              .dimension = 2,
              .cites = "Barth section 3.4, after Lawson 1977",
              .summary = "flips that make the larger angle smaller, until none does: locally optimal",
              .promise = Promise::triangulation,
              .incremental = false},
    .parameters = flip_parameters,
    .run = minmax_local,
};

}  // namespace tribunal
