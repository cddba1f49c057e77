// The greedy triangulation from the Delaunay one: near-linear where the sites are uniform.
#include "algorithms/greedy/from_delaunay.hpp"
#include "algorithms/planar/listed.hpp"

#include <utility>

namespace tribunal {
namespace {

Triangulation greedy(const PlanarProblem& problem) {
  const Triangulation delaunay = green_sibson_algorithm.run(problem);
  GreedyMesh mesh = triangulate_from_delaunay({problem}, delaunay.triangles);
  Triangulation result;
  result.hull = delaunay.hull;
  result.triangles = std::move(mesh.triangles);
  result.counters.flips = mesh.flips;
  result.counters.conflict_tests = mesh.found.conflict_tests;
  result.counters.location_steps = mesh.found.search_steps;
  return result;
}

}  // namespace

constinit const PlanarAlgorithm greedy_algorithm{
    .about = {.name = "greedy",
              .dimension = 2,
              .cites = "Goldman 1989; Levcopoulos, Lingas 1992",
              .summary = "shortest edge first, sought near the Delaunay triangulation: O(N log N) expected",
              .promise = Promise::triangulation,
              .incremental = false},
    .run = greedy,
};

}  // namespace tribunal
