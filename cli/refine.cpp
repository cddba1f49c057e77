// tribunal refine: a user's boundary to a mesh with Steiner points.
#include "algorithms/constrained/polygons.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/refiners.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/measure.hpp"
#include "cli/graph_input.hpp"
#include "cli/lookup.hpp"
#include "cli/outputs.hpp"
#include "cli/predicate_counts.hpp"
#include "cli/statistics.hpp"
#include "cli/verbs.hpp"
#include "datasets/pictures/picture.hpp"
#include "predicates/counted.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <ostream>

namespace tribunal::cli {
namespace {
using nlohmann::json;
using refinement::RefinedGraph;

GraphInput boundary_of(const RefineOptions& options) {
  auto file = read_pslg(options.boundary);
  if (!file) throw BadUsage(options.boundary + ": a boundary comes as .poly, .geojson or .wkt");
  if (file->segments.empty()) throw BadInput(options.boundary + ": holds no segments: there is no boundary");
  return graph_input(options.boundary, std::move(*file), {});
}

std::vector<Edge> subsegments_of(const RefinedGraph& refined) {
  std::vector<Edge> ends;
  for (const auto& part : refined.mesh.subsegments) ends.push_back(part.ends);
  return ends;
}

/// Refuses polygons that bound nothing a mesh could fill.
void require_polygons(const GraphInput& input, const Kernel2& kernel) {
  if (input.file.ring_outers.empty()) return;
  Graph graph = input.graph();
  graph.domain = Domain::hull;
  const auto order = insertion_order(graph.points, Order::hilbert, 1);
  const ConstrainedTriangulation whole = triangulate_graph(graph, order, kernel, Recovery::cavity);
  if (whole.mesh.outcome != Outcome::ok) return;  // refinement will say so, too
  const auto fault = constrained::find_ring_fault(graph, {input.file.segment_rings, input.file.ring_outers},
                                                  whole.touches, kernel);
  if (!fault) return;
  const bool touches = fault->kind == constrained::RingFault::Kind::touches_itself;
  throw BadInput(input.path + ":" + std::to_string(input.file.sites.lines[fault->point]) + ": " +
                 (touches ? "a ring touches itself at this point"
                          : "at this point an inner ring is not inside the polygon's outer one"));
}

/// What signs without a promise have made.
void check(const GraphInput& input, const refinement::Refiner& refiner, RefinedGraph& refined) {
  if (refined.report.mesh.outcome != Outcome::ok) return;
  const std::vector<Edge> segments = subsegments_of(refined);
  const auto verdict = verify::verify_constrained(
      refined.mesh.points, {refined.mesh.triangles},
      {segments, input.file.holes, static_cast<verify::Domain>(input.domain)},
      {.kind = refiner.delaunay ? verify::Kind::delaunay : verify::Kind::triangulation, .max_faults = 1});
  if (verdict.valid()) return;
  refined.report.mesh.outcome = verdict.faults[0].kind == verify::FaultKind::non_delaunay
                                    ? Outcome::non_delaunay
                                    : Outcome::invalid_topology;
  refined.report.mesh.reason = verdict.faults[0].detail;
}

struct Run {
  RefinedGraph refined;
  PredicateCounts predicates;
  double seconds = 0;
};

/// Predicates are counted in a run of its own, so that counting costs no measured time.
Run refine_once(const refinement::Refiner& refiner, const Settings& settings, const GraphInput& input,
                const Kernel2& kernel, bool counted) {
  Run run;
  const Graph graph = input.graph();
  const auto order = insertion_order(graph.points, Order::hilbert, 1);
  const double start = bench::thread_seconds();
  run.refined = refiner.run({graph, order, kernel, settings, input.file.sites.values});
  run.seconds = bench::thread_seconds() - start;
  if (counted)
    refiner.run({graph, order, CountedKernel2(kernel, run.predicates), settings, input.file.sites.values});
  return run;
}

json stats_json(const RefineOptions& options, const Settings& settings, const GraphInput& input,
                const Run& run) {
  const auto& [report, mesh, counts] = run.refined;
  json stats{{"algorithm", options.algorithm},
             {"parameters", settings},
             {"backend", options.backend},
             {"domain", to_string(input.domain)},
             {"n", input.file.sites.points.size()},
             {"segments", input.file.segments.size()},
             {"vertices", mesh.points.size()},
             {"triangles", mesh.triangles.size()},
             {"subsegments", mesh.subsegments.size()},
             {"outcome", to_string(report.mesh.outcome)},
             {"reason", report.mesh.reason},
             {"angles", angles_json(mesh.points, mesh.triangles)},
             {"counts", json::object()},
             {"predicates", predicates_json(run.predicates)},
             {"digest", to_hex(digest(mesh.triangles))},
             {"seconds", run.seconds}};
  for (const auto& [name, value] : counts) stats["counts"][std::string(name)] = value;
  return stats;
}

/// Splits that are rounded may bend the boundary of a hull inwards: it is no hull then, but still held. Holes
/// mean nothing to a hull, and would be carved.
PolyBoundary written_boundary(const GraphInput& input, const std::vector<Edge>& segments) {
  if (input.domain == Domain::hull) return {segments, {}, to_string(Domain::carved)};
  return {segments, input.file.holes, to_string(input.domain)};
}

void write_outputs(const RefineOptions& options, const GraphInput& input, const RefinedGraph& refined) {
  const auto& mesh = refined.mesh;
  const std::vector<Edge> segments = subsegments_of(refined);
  if (!options.output.empty())
    write_bounded_mesh(options.output, mesh.points, mesh.triangles, written_boundary(input, segments));
  Picture(options.picture, options.boundary, input.file.sites, {})
      .draw(mesh.points, mesh.triangles, segments);
}

TableRows summary(const json& stats) {
  constexpr std::array keys{"algorithm", "backend", "n", "segments", "vertices", "triangles", "outcome"};
  TableRows rows = rows_of(stats, keys);
  for (const auto& row : angle_rows(stats.at("angles"))) rows.push_back(row);
  for (const auto& [name, value] : stats.at("counts").items()) rows.push_back({name, plain_text(value)});
  rows.push_back({"seconds", plain_text(stats.at("seconds"))});
  return rows;
}

}  // namespace

int refine(const RefineOptions& options, Console& console) {
  const refinement::Refiner& refiner = refiner_named(options.algorithm);
  const Settings settings = settings_for(refiner.name, refiner.parameters, options.settings);
  const BackendEntry& backend = backend_named(options.backend);
  check_picture(options.picture);
  if (options.picture.colour == "field")
    throw BadUsage("--colour field: new points have no values; there are plain, angle and smallest-angle");
  check_outputs({.inputs = {options.boundary, options.picture.against},
                 .mesh = options.output,
                 .boundary = true,
                 .stats = options.stats,
                 .picture = options.picture.file},
                console);
  const GraphInput input = boundary_of(options);
  const auto& points = input.file.sites;
  const Kernel2Binding bound = backend.bind2(points.points);
  if (const auto* refusal = std::get_if<Refusal>(&bound))
    throw BadInput(options.boundary + ":" + std::to_string(points.lines[refusal->point]) + ": " +
                   options.backend + ": " + refusal->reason);

  require_polygons(input, *std::get<0>(bound));
  const bool counted = console.json || !options.stats.empty();
  Run run = refine_once(refiner, settings, input, *std::get<0>(bound), counted);
  if (!backend.about->exact) check(input, refiner, run.refined);
  const Triangulation& report = run.refined.report.mesh;
  if (report.outcome == Outcome::refused_input) throw BadInput(describe(input, run.refined.report));
  if (report.outcome == Outcome::out_of_domain)
    throw BadInput(options.boundary + ": " + options.backend + ": " + report.reason);

  const json stats = stats_json(options, settings, input, run);
  if (report.outcome == Outcome::ok)
    write_outputs(options, input, run.refined);
  else
    console.log << to_string(report.outcome) << ": " << report.reason << '\n';
  tell(stats, summary(stats), options.output, options.stats, console);
  return report.outcome == Outcome::ok ? good : judged_bad;
}

}  // namespace tribunal::cli
