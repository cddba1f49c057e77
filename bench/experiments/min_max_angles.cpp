// Experiment `min-max-angles`: the extreme angles of the Delaunay triangulation and of MinMax ones.
//
// On distinct points of one dataset. MinMax flips start from the Delaunay triangulation or, by the parameter
// `start`, from one that knows no angles; edge insertion starts where they end. Counters, angles in degrees:
// `delaunay.max`, `delaunay.min`, `local.max`, `local.min`, `global.max`, `global.min`; `gap`, local.max -
// global.max; exactly compared: `local_missed` (1 when the local optimum is not global),
// `delaunay_smaller_max` and `minmax_larger_min` (1 where the one triangulation beats the other at the
// other's goal); `flips` from the start to the local optimum; of the insertion `insertions`, `attempts`,
// `candidates`, `crossings`, `ears`, and `operations`, the sum of the last three; `squared_sites`. Up to 9
// points, parameter `exhaustive`: `triangulations`, how many there are, `best.max`, and `global_missed` (1
// when one of them has a smaller largest angle than edge insertion found).
#include "algorithms/flips/angles.hpp"
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/lawson.hpp"
#include "algorithms/flips/minmax_edge_insertion.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/all_triangulations.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"

#include <array>
#include <utility>

namespace tribunal::bench {
namespace {

constexpr std::size_t most_exhaustive = 9;

constexpr Parameter exhaustive_parameter{
    .name = "exhaustive", .summary = "compare with all triangulations", .standard = "no", .choices = [] {
      return std::vector<std::string_view>{"no", "yes"};
    }};
constexpr Parameter first_parameter{
    .name = "start", .summary = "what MinMax flips start from", .standard = "delaunay", .choices = [] {
      return std::vector<std::string_view>{"delaunay", "sweep", "fan"};
    }};
constexpr std::array parameters{exhaustive_parameter, first_parameter};

void compare_with_all(const Sites& sites, const std::vector<Triangle>& global, Finding& finding) {
  Triangle best = largest_corner(sites, global);
  double triangulations = 0;
  visit_all_triangulations(sites, global, [&](const std::vector<Triangle>& triangles) {
    ++triangulations;
    const Triangle corner = largest_corner(sites, triangles);
    if (sites.compare_angle(corner, best) == Sign::negative) best = corner;
  });
  finding.counters["triangulations"] = triangulations;
  finding.counters["best.max"] = degrees(sites, best);
  finding.counters["global_missed"] =
      sites.compare_angle(best, largest_corner(sites, global)) == Sign::negative;
}

bool is_valid(const Sites& sites, const std::vector<Triangle>& triangles, verify::Kind kind) {
  return verify::verify_planar(sites.points, {.triangles = triangles}, {.kind = kind, .max_faults = 1})
      .valid();
}

Finding run_min_max_angles(const Cell& cell) {
  const std::vector<Point2> points = distinct_points(cell_points(cell));
  std::vector<Index> vertices(points.size());
  for (Index v = 0; v < vertices.size(); ++v) vertices[v] = v;
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const bool exhaustive = choice(cell.parameters, exhaustive_parameter) == "yes";
  if (exhaustive && points.size() > most_exhaustive)
    return {Outcome::refused_input, "more than 9 points have too many triangulations"};
  const Sites sites{points, *std::get<0>(binding)};

  EdgeMesh mesh(start_triangulation(sites, vertices, Start::sweep));
  DelaunayCriterion circles(sites);
  flip_to_optimum(sites, mesh, circles, {});
  const auto delaunay = mesh.triangles();
  if (const std::string start = choice(cell.parameters, first_parameter); start != "delaunay")
    mesh = EdgeMesh(start_triangulation(sites, vertices, start == "fan" ? Start::fan : Start::sweep));
  MinMaxCriterion angles(sites);
  const FlipCounts flips = flip_to_optimum(sites, mesh, angles, {});
  const auto local = mesh.triangles();
  const auto [global, insertion] = insert_edges_for_min_max_angle(sites, local);

  const Triangle of_delaunay = largest_corner(sites, delaunay), of_local = largest_corner(sites, local),
                 of_global = largest_corner(sites, global);
  const Triangle least_of_delaunay = smallest_corner(sites, delaunay),
                 least_of_local = smallest_corner(sites, local);
  const double local_max = degrees(sites, of_local), global_max = degrees(sites, of_global);
  Finding finding{
      .counters = {
          {"runs", 1},
          {"squared_sites", static_cast<double>(points.size() * points.size())},
          {"delaunay.max", degrees(sites, of_delaunay)},
          {"delaunay.min", degrees(sites, least_of_delaunay)},
          {"local.max", local_max},
          {"local.min", degrees(sites, least_of_local)},
          {"global.max", global_max},
          {"global.min", degrees(sites, smallest_corner(sites, global))},
          {"gap", local_max - global_max},
          {"local_missed", sites.compare_angle(of_global, of_local) == Sign::negative},
          {"delaunay_smaller_max", sites.compare_angle(of_delaunay, of_local) == Sign::negative},
          {"minmax_larger_min", sites.compare_angle(least_of_local, least_of_delaunay) == Sign::positive},
          {"delaunay.valid", is_valid(sites, delaunay, verify::Kind::delaunay)},
          {"local.valid", is_valid(sites, local, verify::Kind::triangulation)},
          {"global.valid", is_valid(sites, global, verify::Kind::triangulation)},
          {"flips", static_cast<double>(flips.flips)},
          {"insertions", static_cast<double>(insertion.insertions)},
          {"attempts", static_cast<double>(insertion.attempts)},
          {"candidates", static_cast<double>(insertion.candidates)},
          {"crossings", static_cast<double>(insertion.crossings)},
          {"ears", static_cast<double>(insertion.ears)},
          {"operations", static_cast<double>(insertion.candidates + insertion.crossings + insertion.ears)},
      }};
  if (exhaustive) compare_with_all(sites, global, finding);
  return finding;
}

}  // namespace

constinit const Experiment min_max_angles_experiment{
    .name = "min-max-angles",
    .cites = "Barth, section 3.4; Edelsbrunner, Tan, Waupotitsch 1992",
    .summary = "extreme angles of Delaunay, locally and globally optimal MinMax triangulations",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = parameters,
    .run = run_min_max_angles,
};

}  // namespace tribunal::bench
