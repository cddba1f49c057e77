#include "algorithms/refiners.hpp"

#include "algorithms/constrained/graph_mesh.hpp"
#include "algorithms/refinement/adaptive_parameters.hpp"
#include "algorithms/refinement/chew_parameters.hpp"
#include "algorithms/stretching/parameters.hpp"

#include <algorithm>
#include <array>

namespace tribunal::refinement {
namespace {

RefinedGraph named(Refinement refined) {
  const ChewCounts& counts = refined.counts;
  return {std::move(refined.report),
          std::move(refined.mesh),
          {{"circumcentres", counts.circumcentres},
           {"deleted", counts.deleted},
           {"splits", counts.splits},
           {"refused_splits", counts.refused_splits},
           {"walk_steps", counts.steps},
           {"measured", counts.tests},
           {"stale", counts.stale},
           {"small_input_angles", counts.small_input_angles},
           {"forced", counts.forced},
           {"unresolved", counts.unresolved}}};
}

RefinedGraph run_chew(const RefinementProblem& problem) {
  return named(
      refine_by_circumcentres(problem.graph, problem.order, problem.kernel, chew_options(problem.settings)));
}

RefinedGraph run_adaptive(const RefinementProblem& problem) {
  RefinedGraph result;
  constrained::report_refusals(result.report, [&] {
    const std::unique_ptr<Field> field = field_of(problem);
    result = named(refine_by_solution(problem.graph, problem.order, problem.kernel, *field,
                                      adaptive_options(problem.settings))
                       .refinement);
  });
  return result;
}

RefinedGraph run_stretched(const RefinementProblem& problem) {
  RefinedGraph result;
  constrained::report_refusals(result.report, [&] {
    auto [mesh, distances, counts] = stretching::refine_stretched(
        problem.graph, problem.order, problem.kernel, stretching::options_of(problem.settings));
    result.mesh = std::move(mesh);
    result.counts = {{"inserted", counts.inserted}, {"hidden", counts.hidden}, {"near", counts.near},
                     {"crowded", counts.crowded},   {"trials", counts.trials}, {"swaps", counts.swaps},
                     {"walk_steps", counts.steps}};
  });
  return result;
}

constexpr std::array all{
    Refiner{.name = "chew",
            .cites = "Chew 1989, 1993; Ruppert 1995; Barth section 3.5",
            .summary = "Steiner points at circumcentres until all triangles are small and round enough",
            .parameters = chew_parameters,
            .run = run_chew},
    Refiner{.name = "adaptive",
            .cites = "Barth section 3.5; Chew 1993",
            .summary = "the same, small where a field changes: a formula, or the third column of the points",
            .parameters = adaptive_parameters,
            .run = run_adaptive},
    Refiner{.name = "stretched",
            .cites = "Barth section 3.5",
            .summary = "layers along walls, spaced by the distance from them, with small largest angles",
            .parameters = stretching::parameters,
            .run = run_stretched,
            .delaunay = false},
};

}  // namespace

std::span<const Refiner> refiners() { return all; }

const Refiner* find_refiner(std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Refiner& r) { return r.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal::refinement
