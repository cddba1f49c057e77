// The greedy triangulation with Gilbert's search (1979): all pairs of sites, shortest first, each tried in
// the star of one of its ends. O(n^2 log n) time, O(n^2) storage.
#include "algorithms/greedy/result.hpp"
#include "algorithms/greedy/stars.hpp"
#include "algorithms/planar/listed.hpp"

namespace tribunal {
namespace {

Triangulation greedy_gilbert(const PlanarProblem& problem) {
  Stars stars(problem);
  GreedyEdges found = triangulate_from_pool({problem}, stars);
  found.conflict_tests = stars.tests();
  found.search_steps = stars.steps();
  return greedy_result(problem, found);
}

}  // namespace

constinit const PlanarAlgorithm greedy_gilbert_algorithm{
    .about = {.name = "greedy-gilbert",
              .dimension = 2,
              .cites = "Gilbert 1979",
              .summary =
                  "shortest edge first, tried in a segment tree around its end: O(N^2 log N), N^2 storage",
              .promise = Promise::triangulation,
              .incremental = false},
    .run = greedy_gilbert,
};

}  // namespace tribunal
