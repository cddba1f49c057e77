// Globally optimal MinMax triangulation (Edelsbrunner, Tan, Waupotitsch 1992), Barth section 3.4: from a
// locally optimal one, edges are inserted that break the largest angle, until none does.
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/lawson.hpp"
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/flips/minmax_edge_insertion.hpp"
#include "algorithms/planar/listed.hpp"

namespace tribunal {
namespace {

/// Delaunay first: the way from the sweep's triangles by MinMax flips is long, and ends further off.
Triangulation minmax_global(const PlanarProblem& problem) {
  const Sites sites{problem.points, problem.kernel};
  EdgeMesh mesh(start_triangulation(sites, problem.sites, Start::sweep));
  DelaunayCriterion delaunay(sites);
  MinMaxCriterion min_max(sites);
  FlipCounts counts = flip_to_optimum(sites, mesh, delaunay, {});
  const FlipCounts local = flip_to_optimum(sites, mesh, min_max, {});
  counts.flips += local.flips;
  counts.tests += local.tests;
  Triangulation result = result_of(mesh, counts);
  EdgeInsertionResult optimum = insert_edges_for_min_max_angle(sites, result.triangles);
  result.triangles = std::move(optimum.triangles);
  result.counters.conflict_tests += optimum.counts.ears;
  result.counters.location_steps = optimum.counts.candidates + optimum.counts.crossings;
  return result;
}

}  // namespace

constinit const PlanarAlgorithm minmax_global_algorithm{
    .about = {.name = "minmax-global",
              .dimension = 2,
              .cites = "Edelsbrunner, Tan, Waupotitsch 1992",
              .summary = "edges inserted where they break the largest angle: the smallest there can be",
              .promise = Promise::triangulation,
              .incremental = false},
    .run = minmax_global,
};

}  // namespace tribunal
