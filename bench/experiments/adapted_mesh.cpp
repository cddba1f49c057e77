// Experiment `adapted-mesh`: refinement of the unit square that follows a field.
//
// Counters: `runs` (1); `vertices`, `triangles`; `valid` (constrained Delaunay, exactly); `before` and
// `after`, the largest measure of the field in the square cut in two and in the result, and `left`, their
// ratio; `over`, how much of the tolerance the latter exceeds (0: nothing); `band_area`, the part of the
// square where the field's gradient is more than a tenth of the steepest, on a lattice; `band_vertices`, the
// part of the vertices there; `concentration`, their ratio.
#include "algorithms/refinement/adaptive_parameters.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::bench {
namespace {
using namespace refinement;

constexpr int lattice = 200;

double steepness(Field& field, Point2 p) {
  constexpr double step = 1e-4;
  const double dx = field.at({{p[0] + step, p[1]}}) - field.at({{p[0] - step, p[1]}});
  const double dy = field.at({{p[0], p[1] + step}}) - field.at({{p[0], p[1] - step}});
  return std::sqrt(dx * dx + dy * dy) / (2 * step);
}

std::vector<Point2> lattice_points() {
  std::vector<Point2> points;
  for (int i = 0; i < lattice; ++i)
    for (int j = 0; j < lattice; ++j) points.push_back({{(i + 0.5) / lattice, (j + 0.5) / lattice}});
  return points;
}

double part_above(Field& field, const std::vector<Point2>& points, double limit) {
  const auto above = std::count_if(points.begin(), points.end(),
                                   [&](const Point2& p) { return steepness(field, p) > limit; });
  return static_cast<double>(above) / static_cast<double>(points.size());
}

Finding run_adapted_mesh(const Cell& cell) {
  const std::vector<Point2> corners{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
  const std::vector<Edge> sides{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const std::vector<Index> order{0, 1, 2, 3};
  const Graph square{corners, sides, {}, Domain::carved};
  const Kernel2Binding binding = cell_kernel(corners, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const std::string name = value_of(cell.parameters, adaptive_parameters[4]);
  if (name == "values") return {Outcome::refused_input, "the corners of the square have no values"};
  const std::unique_ptr<Field> field = formula_field(name);
  const AdaptiveOptions options = adaptive_options(cell.parameters);
  const Adapted adapted = refine_by_solution(square, order, kernel, *field, options);
  const Triangulation& report = adapted.refinement.report.mesh;
  if (report.outcome != Outcome::ok) return {report.outcome, report.reason};

  const Refined& mesh = adapted.refinement.mesh;
  std::vector<Edge> segments;
  for (const Subsegment& part : mesh.subsegments) segments.push_back(part.ends);
  const bool valid = verify::verify_constrained(mesh.points, {.triangles = mesh.triangles},
                                                {segments, {}, verify::Domain::carved}, {.max_faults = 1})
                         .valid();
  const std::vector<Point2> everywhere = lattice_points();
  double steepest = 0;
  for (const Point2& p : everywhere) steepest = std::max(steepest, steepness(*field, p));
  const double area = part_above(*field, everywhere, steepest / 10);
  const double vertices = part_above(*field, mesh.points, steepest / 10);
  return {.counters = {{"runs", 1},
                       {"vertices", static_cast<double>(mesh.points.size())},
                       {"triangles", static_cast<double>(mesh.triangles.size())},
                       {"valid", valid},
                       {"before", adapted.before},
                       {"after", adapted.after},
                       {"left", adapted.after / adapted.before},
                       {"over", std::max(0.0, adapted.after / options.tolerance - 1)},
                       {"band_area", area},
                       {"band_vertices", vertices},
                       {"concentration", vertices / area}}};
}

}  // namespace

constinit const Experiment adapted_mesh_experiment{
    .name = "adapted-mesh",
    .cites = "Barth, Figures 3.5.8 and 3.5.9",
    .summary = "measures and concentration of vertices in refinement that follows a field",
    .reads = {.backend = true},
    .parameters = adaptive_parameters,
    .run = run_adapted_mesh,
};

}  // namespace tribunal::bench
