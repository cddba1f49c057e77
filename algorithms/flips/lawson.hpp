// Lawson's algorithm from a triangulation to start from to the result that users get.
#pragma once

#include "algorithms/flips/flip_engine.hpp"
#include "algorithms/flips/halves.hpp"
#include "algorithms/flips/start.hpp"
#include "algorithms/renumbered.hpp"

#include <cstdint>

namespace tribunal {

/// How edges come to be tested.
enum class Method : std::uint8_t {
  stack,   ///< those around a flip, until none waits
  sweeps,  ///< all of them, until nothing flips
};

struct FlipOptions {
  Start start = Start::sweep;
  std::uint64_t random_flips = 0;  ///< attempts per site, before the criterion is asked
  Method method = Method::stack;
  Scan scan = Scan::ascending;  ///< of sweeps
  std::uint64_t seed = 1;       ///< of random flips and shuffled sweeps
};

/// More flips than any sequence of Lawson's takes: an edge that a Delaunay flip removes never returns, so
/// that there are no more of them than pairs of sites. Other criteria have no proven bound; MinMax flips were
/// seen to take half of it, from a fan over a parabola.
inline std::uint64_t most_flips(std::uint64_t sites) { return sites * (sites + 1) / 2; }

/// Flips the mesh to a local optimum.
template <FlipCriterion Criterion>
FlipCounts flip_to_optimum(const Sites& sites, EdgeMesh& mesh, Criterion& criterion,
                           const FlipOptions& options, std::span<const char> fixed = {}) {
  FlipEngine engine(sites, mesh, criterion, most_flips(sites.points.size()), fixed);
  if (options.method == Method::stack)
    engine.flip_from_stack();
  else
    engine.flip_in_sweeps(options.scan, options.seed);
  return engine.counts();
}

/// What users get of a mesh that was flipped. Triangles made: those of the start, and two by each flip.
inline Triangulation result_of(const EdgeMesh& mesh, const FlipCounts& counts) {
  Triangulation result;
  result.triangles = mesh.triangles();
  for (HalfEdge h = 0; h < 2 * mesh.edges(); ++h) result.hull += mesh.is_outer(h);
  result.counters.created = result.triangles.size() + 2 * counts.flips;
  result.counters.flips = counts.flips;
  result.counters.conflict_tests = counts.tests;
  return result;
}

/// Flips a triangulation of the problem's sites. Criterion is made of the sites.
template <FlipCriterion Criterion>
Triangulation flip_triangles(const PlanarProblem& problem, std::span<const Triangle> start,
                             const FlipOptions& options) {
  const Sites sites{problem.points, problem.kernel};
  EdgeMesh mesh(start);
  flip_at_random(sites, mesh, options.random_flips * problem.sites.size(), options.seed);
  Criterion criterion(sites);
  return result_of(mesh, flip_to_optimum(sites, mesh, criterion, options));
}

/// Triangulates the problem's sites by flips alone; their order does not matter.
template <FlipCriterion Criterion>
Triangulation triangulate_by_flips(const PlanarProblem& problem, const FlipOptions& options) {
  const Sites sites{problem.points, problem.kernel};
  // Sweeps go by the names of sites; all else may name them so that neighbours lie together.
  if (options.start != Start::halves || options.method == Method::sweeps)
    return flip_triangles<Criterion>(problem, start_triangulation(sites, problem.sites, options.start),
                                     options);
  const Halved start = triangulate_by_halves(sites, problem.sites);
  const PlanarProblem in_order{problem.points, start.order, problem.kernel, problem.settings};
  const Renumbered renumbered(in_order);
  Triangulation result = flip_triangles<Criterion>(renumbered.problem(), start.triangles, options);
  renumbered.restore(result);
  return result;
}

}  // namespace tribunal
