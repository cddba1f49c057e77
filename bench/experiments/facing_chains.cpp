// Experiment `facing-chains`: how many flips the facing chains take.
//
// The first n points of the dataset `lawson-worst-case`, n = 2m, from the triangulation whose diagonals are
// longest.
// Counters: `flips`, `tests`, `sweeps`; `formula`, (m - 2)(2m - 5) / 2, the flips that sweeps in ascending
// order take; `excess`, flips beyond it, and `sweeps_excess`, sweeps beyond m - 1; `delaunay` (1 when the end
// is valid as that).
#include "bench/experiments/facing_chains.hpp"

#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/parameters.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/dataset.hpp"

#include <array>

namespace tribunal::bench {
namespace {

constexpr std::array parameters{method_parameter, scan_parameter, flip_seed_parameter};

Finding run_facing_chains(const Cell& cell) {
  const std::vector<Point2> points = find_dataset("lawson-worst-case")->generate(cell.n, 0);
  if (points.size() < 8) return {Outcome::refused_input, "the chains begin with n = 8 points"};
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Sites sites{points, *std::get<0>(binding)};
  const auto m = static_cast<Index>(points.size() / 2);
  EdgeMesh mesh(facing_chains_start(m));
  DelaunayCriterion delaunay(sites);
  const FlipCounts counts = flip_to_optimum(sites, mesh, delaunay, flip_options(cell.parameters));
  const auto triangles = mesh.triangles();
  const double flips = static_cast<double>(counts.flips), formula = (m - 2.0) * (2.0 * m - 5) / 2;
  return {.counters = {{"flips", flips},
                       {"tests", static_cast<double>(counts.tests)},
                       {"sweeps", static_cast<double>(counts.sweeps)},
                       {"formula", formula},
                       {"excess", flips - formula},
                       {"sweeps_excess", static_cast<double>(counts.sweeps) - (m - 1.0)},
                       {"runs", 1},
                       {"delaunay", verify::verify_planar(points, {.triangles = triangles}).valid()}}};
}

}  // namespace

constinit const Experiment facing_chains_experiment{
    .name = "facing-chains",
    .cites = "Barth, section 3.3d",
    .summary = "flips from the worst triangulation of two facing chains, in the order named",
    .reads = {.backend = true, .n = true},
    .parameters = parameters,
    .run = run_facing_chains,
};

}  // namespace tribunal::bench
