#include "algorithms/optimizers.hpp"

#include "algorithms/data_dependent/optimize.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/flips/minmax_edge_insertion.hpp"
#include "algorithms/flips/parameters.hpp"

#include <algorithm>
#include <array>

namespace tribunal {
namespace {

constexpr std::array lawson_parameters{random_flips_parameter, method_parameter, scan_parameter,
                                       flip_seed_parameter};

template <class Criterion>
OptimizedMesh flip(const MeshProblem& problem) {
  const FlipOptions options = flip_options(problem.settings);
  EdgeMesh mesh(problem.triangles);
  flip_at_random(problem.sites, mesh, options.random_flips * problem.sites.points.size(), options.seed);
  Criterion criterion(problem.sites);
  const FlipCounts counts = flip_to_optimum(problem.sites, mesh, criterion, options);
  return {mesh.triangles(),
          {{"flips", counts.flips},
           {"tests", counts.tests},
           {"convexity_tests", counts.convexity_tests},
           {"sweeps", counts.sweeps}}};
}

OptimizedMesh insert_edges(const MeshProblem& problem) {
  auto [triangles, counts] = insert_edges_for_min_max_angle(problem.sites, problem.triangles);
  return {std::move(triangles),
          {{"insertions", counts.insertions},
           {"attempts", counts.attempts},
           {"candidates", counts.candidates},
           {"crossings", counts.crossings},
           {"ears", counts.ears}}};
}

constexpr std::array surface_parameters{cost_parameter, norm_parameter, search_parameter,
                                        flip_seed_parameter};

OptimizedMesh smooth_surface(const MeshProblem& problem) {
  EdgeMesh mesh(problem.triangles);
  const FlipCounts counts = flip_for_data(problem.sites, mesh, problem.values, problem.settings);
  return {mesh.triangles(), {{"flips", counts.flips}, {"tests", counts.tests}, {"sweeps", counts.sweeps}}};
}

constexpr std::array optimizers{
    MeshOptimizer{.name = "delaunay",
                  .cites = "Lawson 1977; Barth section 3.3d",
                  .summary = "flips until all circles are empty",
                  .parameters = lawson_parameters,
                  .run = flip<DelaunayCriterion>},
    MeshOptimizer{.name = "minmax",
                  .cites = "Barth section 3.4",
                  .summary = "flips that make the larger angle smaller, until none does",
                  .parameters = lawson_parameters,
                  .run = flip<MinMaxCriterion>},
    MeshOptimizer{.name = "minmax-global",
                  .cites = "Edelsbrunner, Tan, Waupotitsch 1992",
                  .summary = "edges inserted where they break the largest angle: the smallest there can be",
                  .run = insert_edges},
    MeshOptimizer{.name = "data-dependent",
                  .cites = "Dyn, Levin, Rippa 1990; Barth section 3.4",
                  .summary = "flips that make the surface over the points less rough",
                  .reads_values = true,
                  .parameters = surface_parameters,
                  .run = smooth_surface}};

}  // namespace

std::span<const MeshOptimizer> mesh_optimizers() { return optimizers; }

const MeshOptimizer* find_mesh_optimizer(std::string_view name) {
  const auto found = std::find_if(optimizers.begin(), optimizers.end(),
                                  [&](const MeshOptimizer& o) { return o.name == name; });
  return found == optimizers.end() ? nullptr : &*found;
}

}  // namespace tribunal
