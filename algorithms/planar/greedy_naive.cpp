// The greedy triangulation as Barth outlines it (section 3.4): all pairs of sites, shortest first, each tried
// against every edge that is in. O(n^3).
#include "algorithms/greedy/accepted_list.hpp"
#include "algorithms/greedy/result.hpp"
#include "algorithms/planar/listed.hpp"

namespace tribunal {
namespace {

Triangulation greedy_naive(const PlanarProblem& problem) {
  AcceptedList accepted(problem, false);
  GreedyEdges found = triangulate_from_pool({problem}, accepted);
  found.conflict_tests = accepted.tests();
  return greedy_result(problem, found);
}

}  // namespace

constinit const PlanarAlgorithm greedy_naive_algorithm{
    .about = {.name = "greedy-naive",
              .dimension = 2,
              .cites = "Barth, section 3.4",
              .summary = "shortest edge first, tried against all that are in: O(N^3)",
              .promise = Promise::triangulation,
              .incremental = false},
    .run = greedy_naive,
};

}  // namespace tribunal
