// tribunal triangulate: the user's points to a mesh.
#include "algorithms/triangulate.hpp"

#include "algorithms/constrained/parameters.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/judge.hpp"
#include "bench/measure.hpp"
#include "cli/graph_input.hpp"
#include "cli/lookup.hpp"
#include "cli/outputs.hpp"
#include "cli/picture.hpp"
#include "cli/predicate_counts.hpp"
#include "cli/statistics.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "predicates/counted.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <ostream>

namespace tribunal::cli {
namespace {
using nlohmann::json;
namespace fs = std::filesystem;

bool names_dataset(const TriangulateOptions& options) {
  return options.points != "-" && !fs::exists(options.points) && find_dataset(options.points) != nullptr;
}

/// What the user chose, by name.
struct Method {
  const PlanarAlgorithm& algorithm;
  Settings settings;
  const BackendEntry& backend;
  std::string order_name;
  Order order;

  bool keeps_segments() const { return algorithm.about.name == "constrained"; }
};

Method method_of(const TriangulateOptions& options) {
  const PlanarAlgorithm& algorithm = algorithm_named(options.algorithm);
  const std::string order = options.order.empty() ? std::string(algorithm.order) : options.order;
  return {algorithm, settings_for(algorithm.about.name, algorithm.parameters, options.settings),
          backend_named(options.backend), order, order_named(order)};
}

/// Points, and segments where the file holds any.
struct Input {
  PointFile alone;
  std::optional<GraphInput> with_segments;

  const PointFile& points() const { return with_segments ? with_segments->file.sites : alone; }
};

void check_request(const TriangulateOptions& options, const Method& method, const Console& console) {
  if (options.n != 0 && !names_dataset(options)) {
    if (options.points != "-" && !fs::exists(options.points)) dataset_named(options.points);
    throw BadUsage("-n goes with a dataset's name, not with a file");
  }
  check_picture(options.picture);
  check_outputs({.inputs = {options.points, options.picture.against},
                 .mesh = options.mesh,
                 .boundary = method.keeps_segments(),
                 .stats = options.stats,
                 .picture = options.picture.file},
                console);
}

/// Without segments there is no domain but the hull.
void require_hull(const TriangulateOptions& options, const Method& method) {
  if (!method.keeps_segments()) return;
  if (constrained::domain(method.settings).value_or(Domain::hull) != Domain::hull)
    throw BadUsage(options.points +
                   " holds no segments that could bound a domain; without them it is the hull");
}

/// A file, standard input ("-"), or, where no such file is, a dataset of that name.
Input input_of(const TriangulateOptions& options, const Method& method) {
  Input input;
  if (names_dataset(options)) {
    require_hull(options, method);
    input.alone.points = generate(dataset_named(options.points), options.n, options.seed);
    return input;
  }
  std::optional<PslgFile> file = read_pslg(options.points);
  if (!file)
    input.alone = read_points(options.points);
  else if (file->segments.empty() && !file->holes.empty())
    throw BadInput(options.points + ":" + std::to_string(file->hole_lines[0]) +
                   ": a hole, but there are no segments to bound it");
  else if (file->segments.empty())
    input.alone = std::move(file->sites);
  else if (!method.keeps_segments())
    throw BadUsage(options.points + " holds segments, which " + options.algorithm +
                   " would lose; --algorithm constrained keeps them");
  else
    input.with_segments = graph_input(options.points, std::move(*file), method.settings);
  if (!input.with_segments) require_hull(options, method);
  return input;
}

/// An algorithm that reads data finds them.
void require_values(const Method& method, const Input& input, const std::string& file) {
  if (!method.algorithm.about.reads_values || !input.points().values.empty()) return;
  if (choice(method.settings, data_parameter) == third_column)
    throw BadInput(
        file + ": " + std::string(method.algorithm.about.name) +
        " reads data values from the third column, and there is none (--set data=F1 takes a function)");
}

/// "coast.xy:17: knuth: ...": where the refused point stands and why it is refused.
std::string describe(const Refusal& refusal, const PointFile& file, const TriangulateOptions& options) {
  const std::string place = refusal.point < file.lines.size() ? std::to_string(file.lines[refusal.point])
                                                              : "point " + std::to_string(refusal.point);
  return options.points + ":" + place + ": " + options.backend + ": " + refusal.reason;
}

struct Run {
  Triangulation result;
  std::optional<ConstrainedTriangulation> constrained;  ///< its triangulation is in `result`
  PredicateCounts counts;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
};

void triangulate_once(const Method& method, const Input& input, std::span<const Index> order,
                      const Kernel2& kernel, Run& run) {
  if (!input.with_segments) {
    run.result = tribunal::triangulate(input.alone.points, order, kernel, method.algorithm, method.settings,
                                       input.alone.values);
    return;
  }
  run.constrained =
      triangulate_graph(input.with_segments->graph(), order, kernel, constrained::recovery(method.settings));
  run.result = std::move(run.constrained->mesh);
}

/// The exact checker's word on the result of a backend that promises nothing.
void judge(const Input& input, Promise promise, Run& run) {
  if (!input.with_segments) {
    const bench::Judgement judgement = bench::judge(input.alone.points, run.result, promise);
    run.result.outcome = judgement.outcome;
    run.result.reason = judgement.reason;
    return;
  }
  const Graph graph = input.with_segments->graph();
  const auto verdict = verify::verify_constrained(
      graph.points, {run.result.triangles},
      {graph.segments, graph.holes, static_cast<verify::Domain>(graph.domain)}, {.max_faults = 1});
  if (verdict.valid()) return;
  const auto& fault = verdict.faults.front();
  run.result.outcome =
      fault.kind == verify::FaultKind::non_delaunay ? Outcome::non_delaunay : Outcome::invalid_topology;
  run.result.reason = fault.detail;
}

/// Triangulates. Predicates are counted in a run of its own where somebody wants them, so that counting costs
/// no measured time.
Run run_method(const Method& method, const Input& input, const Kernel2& kernel, std::uint64_t seed,
               bool counted) {
  Run run;
  const auto order = insertion_order(input.points().points, method.order, seed);
  const bench::PeakMemory memory;
  const double start = bench::thread_seconds();
  triangulate_once(method, input, order, kernel, run);
  run.seconds = bench::thread_seconds() - start;
  run.peak_bytes = memory.growth();
  if (counted) {
    Run again;
    triangulate_once(method, input, order, CountedKernel2(kernel, run.counts), again);
  }
  if (!method.backend.about->exact && run.result.outcome == Outcome::ok)
    judge(input, method.algorithm.about.promise, run);
  return run;
}

json stats_json(const TriangulateOptions& options, const Method& method, const Input& input, const Run& run) {
  const Triangulation& t = run.result;
  json history = nullptr;
  if (t.history)
    history = {{"nodes", t.history->nodes},
               {"depth_mean", t.history->depth_mean},
               {"depth_late_mean", t.history->depth_late_mean},
               {"depth_max", t.history->depth_max}};
  json stats{
      {"algorithm", options.algorithm},
      {"parameters", method.settings},
      {"backend", options.backend},
      {"order", method.order_name},
      {"seed", options.seed},
      {"n", input.points().points.size()},
      {"segments", run.constrained ? segments_json(*input.with_segments, *run.constrained) : json(nullptr)},
      {"duplicates", t.duplicates.size()},
      {"outcome", to_string(t.outcome)},
      {"reason", t.reason},
      {"dimension", t.dimension},
      {"triangles", t.triangles.size()},
      {"angles", angles_json(input.points().points, t.triangles)},
      {"edges", t.edges},
      {"hull", t.hull},
      {"history", history},
      {"predicates", predicates_json(run.counts)},
      {"digest", to_hex(digest(t.triangles))},
      {"seconds", run.seconds},
      {"peak_bytes", run.peak_bytes}};
  for (const auto& [name, count] : by_name(t.counters)) stats[name] = count;
  return stats;
}

void report_duplicates(const PointFile& file, const Triangulation& t, const TriangulateOptions& options,
                       Console& console) {
  constexpr std::size_t most_named = 10;
  if (t.duplicates.size() > most_named || file.lines.empty()) {
    if (!t.duplicates.empty()) console.log << t.duplicates.size() << " duplicate points merged\n";
    return;
  }
  for (const auto& [repeated, first] : t.duplicates)
    console.log << options.points << ':' << file.lines[repeated] << ": the same point as line "
                << file.lines[first] << ", merged\n";
}

/// Mesh and picture. Beside a constrained mesh goes a .poly with its segments, even if there are none.
void write_outputs(const TriangulateOptions& options, const Method& method, const Input& input,
                   const Run& run, const Picture& picture) {
  const auto& points = input.points().points;
  const auto& graph = input.with_segments;
  PolyBoundary boundary{{}, {}, to_string(Domain::hull)};
  if (graph) boundary = {graph->file.segments, graph->file.holes, to_string(graph->domain)};
  if (!options.mesh.empty() && method.keeps_segments())
    write_bounded_mesh(options.mesh, points, run.result.triangles, boundary);
  else if (!options.mesh.empty())
    write_mesh(options.mesh, points, run.result.triangles);
  picture.draw(points, run.result.triangles, graph ? run.constrained->constraints : std::vector<Edge>{});
}

}  // namespace

int triangulate(const TriangulateOptions& options, Console& console) {
  const Method method = method_of(options);
  check_request(options, method, console);
  const Input input = input_of(options, method);
  require_values(method, input, options.points);
  const Picture picture(options.picture, options.points, input.points(), method.settings);

  Run run;
  const Kernel2Binding bound = method.backend.bind2(input.points().points);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) {
    run.result.outcome = Outcome::out_of_domain;
    run.result.reason = describe(*refusal, input.points(), options);
  } else {
    const bool counted = console.json || !options.stats.empty();
    run = run_method(method, input, *std::get<0>(bound), options.seed, counted);
  }
  Triangulation& result = run.result;
  if (run.constrained &&
      (result.outcome == Outcome::refused_input || result.outcome == Outcome::out_of_domain)) {
    run.constrained->mesh.reason = result.reason;
    result.reason = cli::describe(*input.with_segments, *run.constrained);
  }
  const json stats = stats_json(options, method, input, run);

  report_duplicates(input.points(), result, options, console);
  if (result.outcome == Outcome::ok) write_outputs(options, method, input, run, picture);
  const bool refused = result.outcome == Outcome::out_of_domain || result.outcome == Outcome::refused_input;
  if (result.outcome != Outcome::ok && !refused)
    console.log << to_string(result.outcome) << ": " << result.reason << '\n';
  constexpr std::array keys{"algorithm", "backend", "n",   "duplicates", "outcome", "dimension",
                            "triangles", "hull",    "tau", "flips",      "digest",  "seconds"};
  TableRows rows = refused ? TableRows{} : rows_of(stats, keys);
  if (!result.triangles.empty())
    for (const auto& row : angle_rows(stats.at("angles"))) rows.push_back(row);
  tell(stats, rows, options.mesh, options.stats, console);
  if (refused) throw BadInput(result.reason);
  return result.outcome == Outcome::ok ? good : judged_bad;
}

}  // namespace tribunal::cli
