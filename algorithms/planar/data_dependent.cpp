// Data-dependent triangulation (Dyn, Levin, Rippa 1990; Barth, section 3.4): from the Delaunay triangulation,
// flips that make the interpolating surface less rough.
#include "algorithms/data_dependent/optimize.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/flips/lawson.hpp"
#include "algorithms/planar/listed.hpp"

#include <vector>

namespace tribunal {
namespace {

Triangulation data_dependent(const PlanarProblem& problem) {
  const std::vector<double> data = chosen_data(problem.points, problem.values, problem.settings);
  const Sites sites{problem.points, problem.kernel};
  EdgeMesh mesh(green_sibson_algorithm.run({problem.points, problem.sites, problem.kernel}).triangles);
  return result_of(mesh, flip_for_data(sites, mesh, data, problem.settings));
}

}  // namespace

constinit const PlanarAlgorithm data_dependent_algorithm{
    .about = {.name = "data-dependent",
              .dimension = 2,
              .cites = "Dyn, Levin, Rippa 1990; Barth section 3.4",
              .summary = "Delaunay, then flips that make the surface over the points less rough",
              .promise = Promise::triangulation,
              .incremental = false,
              .reads_values = true},
    .parameters = data_dependent_parameters,
    .run = data_dependent,
};

}  // namespace tribunal
