// Experiment `roughness-laws`: what the costs of data-dependent triangulation are, and what a flip does to
// them.
//
// The corners of the unit square and n - 4 random points with values of one of Franke's functions times
// `steepness`; the Delaunay triangulation, flipped as the text's loops do by the cost and norm chosen. Before
// each flip and after it all costs are computed anew.
//
// Counters: `runs` (1); `edges` (inner ones looked at, before the first flip); `jump_apart` (largest
// difference between JND and the length of the gradients' difference, relative to the sum of the gradients'
// lengths); `jump_scaled` (the same where the normal is as long as the edge and not of length 1); `obtuse`
// (edges whose normals make an angle of more than 90 degrees), `widest` (the largest, in degrees); of the
// flips: `flips`, `most_changed` (edges whose cost one of them changed, at most), `local_apart` (largest
// difference between the change of the five costs and that of the sum of all, relative to that sum), `rises`
// (flips after which the sum, added up anew, was not smaller by more than its rounding would hide).
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/data_dependent/roughness_criterion.hpp"
#include "bench/experiments/franke_data.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr Parameter steepness_parameter{.name = "steepness",
                                        .summary = "by which values are multiplied",
                                        .standard = "1",
                                        .least = 1,
                                        .most = 1000};
constexpr std::array parameters{function_parameter, cost_parameter, norm_parameter, steepness_parameter};

/// The gradient of the plane over a triangle by Cramer's rule on its equation, unlike the code on trial.
std::array<double, 2> plane(const std::vector<Point2>& points, const std::vector<double>& data, Index a,
                            Index b, Index c) {
  const auto &p = points[a], &q = points[b], &r = points[c];
  const double normal_x = (q[1] - p[1]) * (data[c] - data[a]) - (data[b] - data[a]) * (r[1] - p[1]);
  const double normal_y = (data[b] - data[a]) * (r[0] - p[0]) - (q[0] - p[0]) * (data[c] - data[a]);
  const double normal_z = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return {-normal_x / normal_z, -normal_y / normal_z};
}

struct Data {
  const std::vector<Point2>& points;
  const std::vector<double>& values;
};

void look_at_costs(const Data& data, const EdgeMesh& mesh, Finding& finding) {
  const Roughness jnd(data.points, data.values, Cost::jump_in_normal_derivatives, Norm::l1),
      abn(data.points, data.values, Cost::angle_between_normals, Norm::l1);
  for (Index edge = 0; edge < mesh.edges(); ++edge) {
    if (!mesh.is_inner(edge)) continue;
    const Quadrilateral q = quadrilateral(mesh, edge);
    const auto [a1, b1] = plane(data.points, data.values, q.from, q.to, q.left);
    const auto [a2, b2] = plane(data.points, data.values, q.to, q.from, q.right);
    const double jump = std::hypot(a1 - a2, b1 - b2), size = std::hypot(a1, b1) + std::hypot(a2, b2);
    const double length = std::hypot(data.points[q.from][0] - data.points[q.to][0],
                                     data.points[q.from][1] - data.points[q.to][1]);
    const double cost = jnd.across(mesh, edge), angle = abn.across(mesh, edge) * 180 / std::numbers::pi;
    auto& counters = finding.counters;
    ++counters["edges"];
    if (size > 0) {
      counters["jump_apart"] = std::max(counters["jump_apart"], std::fabs(cost - jump) / size);
      counters["jump_scaled"] = std::max(counters["jump_scaled"], std::fabs(cost * length - jump) / size);
    }
    counters["obtuse"] += angle > 90;
    counters["widest"] = std::max(counters["widest"], angle);
  }
}

std::vector<double> all_costs(const Roughness& roughness, const EdgeMesh& mesh) {
  std::vector<double> costs(mesh.edges(), 0);
  for (Index edge = 0; edge < mesh.edges(); ++edge)
    if (mesh.is_inner(edge)) costs[edge] = roughness.across(mesh, edge);
  return costs;
}

/// The criterion, watched: told of a flip it adds everything up again.
class Watched {
 public:
  static constexpr bool implies_convexity = false;
  static constexpr int reach = RoughnessCriterion::reach;

  Watched(const Roughness& roughness, const EdgeMesh& mesh, Finding& finding)
      : roughness_(roughness), finding_(finding), costs_(all_costs(roughness, mesh)) {}

  bool improves(const EdgeMesh& mesh, Index edge) {
    change_ = roughness_.change_by_flip(mesh, edge);
    return change_.is_better();
  }
  void flipped(const EdgeMesh& mesh, Index) {
    std::vector<double> costs = all_costs(roughness_, mesh);
    double changed = 0, before = 0, gain = 0;
    for (std::size_t edge = 0; edge < costs.size(); ++edge) {
      changed += costs[edge] != costs_[edge];
      before += costs_[edge];
      gain += costs_[edge] - costs[edge];
    }
    auto& counters = finding_.counters;
    ++counters["flips"];
    counters["most_changed"] = std::max(counters["most_changed"], changed);
    counters["local_apart"] = std::max(counters["local_apart"], std::fabs(gain - change_.gain()) / before);
    counters["rises"] += !(gain > 0);
    costs_ = std::move(costs);
  }

 private:
  const Roughness& roughness_;
  Finding& finding_;
  std::vector<double> costs_;
  Roughness::Change change_;
};

Finding run_roughness_laws(const Cell& cell) {
  if (cell.n < 4 || cell.n > 2000) return {Outcome::refused_input, "n is 4 to 2000"};
  const std::vector<Point2> points = corners_and_random_points(cell.n, cell.seed);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const Triangulation delaunay = delaunay_of(points, kernel);
  if (delaunay.outcome != Outcome::ok) return {delaunay.outcome, delaunay.reason};

  std::vector<double> values = sample(chosen_function(cell), points);
  const auto steepness = static_cast<double>(whole_number(cell.parameters, steepness_parameter));
  for (double& value : values) value *= steepness;
  Finding finding;
  finding.counters["runs"] = 1;
  for (const char* name : {"flips", "rises", "most_changed", "local_apart", "obtuse"})
    finding.counters[name] = 0;
  EdgeMesh mesh(delaunay.triangles);
  look_at_costs({points, values}, mesh, finding);
  const Sites sites{points, kernel};
  const Roughness roughness(points, values, choice_as<Cost>(cell.parameters, cost_parameter),
                            choice_as<Norm>(cell.parameters, norm_parameter));
  Watched watched(roughness, mesh, finding);
  FlipEngine engine(sites, mesh, watched, most_flips(points.size()));
  engine.flip_in_sweeps(Scan::ascending);
  return finding;
}

}  // namespace

constinit const Experiment roughness_laws_experiment{
    .name = "roughness-laws",
    .cites = "Dyn, Levin, Rippa 1990; Barth, section 3.4",
    .summary = "what the costs of data-dependent triangulation are, and what each flip does to them",
    .reads = {.backend = true, .n = true, .seed = true},
    .parameters = parameters,
    .run = run_roughness_laws,
};

}  // namespace tribunal::bench
