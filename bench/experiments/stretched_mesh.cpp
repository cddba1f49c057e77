// Experiment `stretched-mesh`: what stretched refinement makes of a dataset's domain.
//
// Counters: `runs` (1); `vertices`, `triangles`; `valid` (segments and domain, exactly); `max_angle`
// (degrees); `aspect`, the largest ratio of a longest edge to the height over it; `wall_vertices`, and
// `first_layer`, those of them with a vertex one wall spacing away, within a millionth of it; `closest`, the
// smallest distance of a vertex from the walls over the wall spacing; and the counts of stretched.hpp:
// `inserted`, `hidden`, `near`, `crowded`, `trials`, `swaps`, `steps`, `work` (the sum of the last three),
// `worst_measure`. One sample of time: the refinement.
#include "algorithms/abandon.hpp"
#include "algorithms/stretching/parameters.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/experiments/mesh_angles.hpp"
#include "bench/input.hpp"
#include "bench/measure.hpp"

#include <limits>
#include <set>

namespace tribunal::bench {
namespace {

void measure_layers(const stretching::Stretched& found, double spacing,
                    std::map<std::string, double>& counters) {
  const auto& [points, triangles, subsegments] = found.mesh;
  const auto on_wall = [&](Index v) { return found.distances[v] == 0; };
  std::set<Index> wall_vertices, with_layer;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      if (!on_wall(t[i])) continue;
      wall_vertices.insert(t[i]);
      for (const Index other : {t[(i + 1) % 3], t[(i + 2) % 3]}) {
        const double apart =
            std::hypot(points[t[i]][0] - points[other][0], points[t[i]][1] - points[other][1]);
        if (!on_wall(other) && std::abs(apart / spacing - 1) <= 1e-6) with_layer.insert(t[i]);
      }
    }
  double closest = std::numeric_limits<double>::infinity();
  for (const double distance : found.distances)
    if (distance > 0) closest = std::min(closest, distance);
  counters["wall_vertices"] = static_cast<double>(wall_vertices.size());
  counters["first_layer"] = static_cast<double>(with_layer.size());
  counters["closest"] = closest / spacing;
}

Finding run_stretched_mesh(const Cell& cell) {
  const DatasetGraph domain = cell_graph(cell);
  const Kernel2Binding binding = cell_kernel(domain.points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Graph graph{domain.points, domain.segments, domain.holes, Domain::carved};
  const auto order = insertion_order(domain.points, Order::brio, 1);
  const stretching::Options options = stretching::options_of(cell.parameters);
  stretching::Stretched found;
  const double start = thread_seconds();
  try {
    found = refine_stretched(graph, order, *std::get<0>(binding), options);
  } catch (const Abandon& abandon) {
    return {abandon.outcome, abandon.what()};
  }
  const double seconds = thread_seconds() - start;
  const auto& [points, triangles, subsegments] = found.mesh;
  const bool valid = verify::verify_constrained(points, {.triangles = triangles},
                                                {domain.segments, domain.holes, verify::Domain::carved},
                                                {.kind = verify::Kind::triangulation, .max_faults = 1})
                         .valid();
  const MeshShape shape = shape_of(points, triangles);
  const stretching::Counts& c = found.counts;
  const auto number = [](std::uint64_t count) { return static_cast<double>(count); };
  Finding finding{.counters = {{"runs", 1},
                               {"vertices", number(points.size())},
                               {"triangles", number(triangles.size())},
                               {"valid", valid},
                               {"max_angle", shape.largest_angle},
                               {"aspect", shape.aspect},
                               {"inserted", number(c.inserted)},
                               {"hidden", number(c.hidden)},
                               {"near", number(c.near)},
                               {"crowded", number(c.crowded)},
                               {"trials", number(c.trials)},
                               {"swaps", number(c.swaps)},
                               {"steps", number(c.steps)},
                               {"work", number(c.trials + c.swaps + c.steps)},
                               {"worst_measure", c.worst_measure}},
                  .seconds = {seconds}};
  measure_layers(found, options.spacing.wall, finding.counters);
  return finding;
}

}  // namespace

constinit const Experiment stretched_mesh_experiment{
    .name = "stretched-mesh",
    .cites = "Barth, section 3.5",
    .summary = "angles, aspect ratios, layers and work of stretched refinement",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = stretching::parameters,
    .run = run_stretched_mesh,
};

}  // namespace tribunal::bench
