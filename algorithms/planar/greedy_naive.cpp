// The greedy triangulation as Barth outlines it (section 3.4): all pairs of sites, shortest first, each tried
// against every edge that is in. O(n^3).
#include "algorithms/greedy/accepted_list.hpp"
#include "algorithms/greedy/result.hpp"
#include "algorithms/planar/listed.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace tribunal {
namespace {

constexpr Parameter scan_parameter{
    .name = "scan",
    .summary = "how much of T a candidate is tried against",
    .standard = "early",
    .choices = [] {
      return std::vector<std::string_view>{"early", "full"};  // up to the first crossing, or all
    }};
constexpr std::array parameters{scan_parameter};

Triangulation greedy_naive(const PlanarProblem& problem) {
  AcceptedList accepted(problem, choice(problem.settings, scan_parameter) == "full");
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
    .parameters = parameters,
    .run = greedy_naive,
};

}  // namespace tribunal
