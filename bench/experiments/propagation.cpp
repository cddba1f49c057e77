// Experiment `propagation`: what an insertion with the MinMax criterion leaves when flips propagate forward
// only.
//
// Counters, for `both` and `forward`: `<name>.left`, flips that would still improve; `<name>.flips` that were
// made; `<name>.max`, the largest angle in degrees; `<name>.valid`.
#include "algorithms/flips/angles.hpp"
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"

namespace tribunal::bench {
namespace {

double improving_flips(const Sites& sites, std::span<const Triangle> triangles) {
  const EdgeMesh mesh(triangles);
  const MinMaxCriterion criterion(sites);
  double count = 0;
  for (Index edge = 0; edge < mesh.edges(); ++edge)
    count += mesh.is_inner(edge) && is_strictly_convex(sites, quadrilateral(mesh, edge)) &&
             criterion.improves(mesh, edge);
  return count;
}

Finding run_propagation(const Cell& cell) {
  const std::vector<Point2> points = distinct_points(cell_points(cell));
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Sites sites{points, *std::get<0>(binding)};
  const std::vector<Index> order = cell_order(points, cell, cell.order_seed);
  Finding finding{.counters = {{"runs", 1}}};
  for (const std::string name : {"both", "forward"}) {
    const Triangulation t = triangulate(
        points, order, sites.kernel, *find_planar_algorithm("green-sibson-minmax"), {{"propagation", name}});
    if (t.outcome != Outcome::ok) return {t.outcome, t.reason};
    finding.counters[name + ".left"] = improving_flips(sites, t.triangles);
    finding.counters[name + ".flips"] = static_cast<double>(t.counters.flips);
    finding.counters[name + ".max"] = degrees(sites, largest_corner(sites, t.triangles));
    finding.counters[name + ".valid"] =
        verify::verify_planar(points, {.triangles = t.triangles}, {.kind = verify::Kind::triangulation})
            .valid();
  }
  return finding;
}

}  // namespace

constinit const Experiment propagation_experiment{
    .name = "propagation",
    .cites = "Barth, section 3.4",
    .summary = "flips that insertion with the MinMax criterion leaves, with and without backward propagation",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true, .order = true},
    .parameters = {},
    .run = run_propagation,
};

}  // namespace tribunal::bench
