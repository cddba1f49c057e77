// Experiment `trailing-edge-angles`: the largest angle of the constrained Delaunay triangulation of a domain
// with given points inside, and what MinMax swaps make of it.
//
// Counters: `runs` (1); `delaunay.max` and `minmax.max` (degrees); `delaunay.short`, how much the first falls
// short of 180; `delaunay.valid` and `minmax.valid`; `swaps`; `triangles`.
#include "algorithms/constrained/graph_mesh.hpp"
#include "algorithms/stretching/min_max_insertion.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/experiments/mesh_angles.hpp"
#include "bench/input.hpp"

namespace tribunal::bench {
namespace {

std::vector<Triangle> domain_of(const constrained::GraphMesh& built) {
  std::vector<Triangle> triangles;
  const PlanarMesh& t = built.mesh.triangles();
  for (Index i = 0; i < t.triangles(); ++i) {
    if (!built.mesh.inside(i)) continue;
    const auto [a, b, c] = t.triangle(i);
    triangles.push_back({built.point[a], built.point[b], built.point[c]});
  }
  return triangles;
}

bool is_valid(const DatasetGraph& domain, const std::vector<Triangle>& triangles, verify::Kind kind) {
  return verify::verify_constrained(domain.points, {.triangles = triangles},
                                    {domain.segments, domain.holes, verify::Domain::carved},
                                    {.kind = kind, .max_faults = 1})
      .valid();
}

Finding measure(const DatasetGraph& domain, const Kernel2& kernel) {
  const Graph graph{domain.points, domain.segments, domain.holes, Domain::carved};
  const auto order = insertion_order(domain.points, Order::brio, 1);
  const auto sites = constrained::distinct_sites(graph, order, kernel);
  auto built = constrained::build_graph_mesh(graph, sites, kernel, Recovery::cavity);
  built.mesh.confine({built.inside.begin(), built.inside.end()});

  const std::vector<Triangle> delaunay = domain_of(built);
  const stretching::MinMaxInsertion swapped(built.mesh);
  const std::vector<Triangle> min_max = domain_of(built);
  const double before = shape_of(domain.points, delaunay).largest_angle;
  return {.counters = {{"runs", 1},
                       {"triangles", static_cast<double>(delaunay.size())},
                       {"delaunay.max", before},
                       {"delaunay.short", 180 - before},
                       {"delaunay.valid", is_valid(domain, delaunay, verify::Kind::delaunay)},
                       {"minmax.max", shape_of(domain.points, min_max).largest_angle},
                       {"minmax.valid", is_valid(domain, min_max, verify::Kind::triangulation)},
                       {"swaps", static_cast<double>(swapped.swaps())}}};
}

Finding run_trailing_edge_angles(const Cell& cell) {
  const DatasetGraph domain = cell_graph(cell);
  const Kernel2Binding binding = cell_kernel(domain.points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  try {
    return measure(domain, *std::get<0>(binding));
  } catch (const Abandon& abandon) {
    return {abandon.outcome, abandon.what()};
  }
}

}  // namespace

constinit const Experiment trailing_edge_angles_experiment{
    .name = "trailing-edge-angles",
    .cites = "Barth, Figures 3.4.3 to 3.4.5",
    .summary = "largest angles in a domain: constrained Delaunay, and MinMax swaps from there",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_trailing_edge_angles,
};

}  // namespace tribunal::bench
