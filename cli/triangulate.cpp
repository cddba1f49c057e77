// tribunal triangulate: the user's points to a mesh.
#include "algorithms/triangulate.hpp"

#include "algorithms/mesh/canonical.hpp"
#include "bench/judge.hpp"
#include "bench/measure.hpp"
#include "cli/lookup.hpp"
#include "cli/predicate_counts.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/picture.hpp"
#include "datasets/files/text.hpp"
#include "predicates/counted.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <ostream>

namespace tribunal::cli {
namespace {
using nlohmann::json;
namespace fs = std::filesystem;

bool names_dataset(const TriangulateOptions& options) {
  return options.points != "-" && !fs::exists(options.points) && find_dataset(options.points) != nullptr;
}

/// A file, standard input ("-"), or, where no such file is, a dataset of that name.
PointFile points_of(const TriangulateOptions& options) {
  if (!names_dataset(options)) return read_points(options.points);
  PointFile file;
  file.points = generate(dataset_named(options.points), options.n, options.seed);
  return file;
}

/// What is wrong with the outputs is said before anything is computed.
void check_outputs(const TriangulateOptions& options, const Console& console) {
  if (options.n != 0 && !names_dataset(options))
    throw BadUsage("-n goes with a dataset's name, not with a file");
  if (console.json && (options.mesh == "-" || options.stats == "-"))
    throw BadUsage("--json and another output both want standard output");
  if (!options.picture.empty()) require_picture_ending(options.picture);
  if (options.mesh.empty() || options.mesh == "-") return;
  std::error_code none;
  for (const fs::path& file : mesh_files(options.mesh))
    if (fs::equivalent(file, options.points, none))
      throw BadUsage(file.string() + " would overwrite its own input");
}

/// "coast.xy:17: knuth: ...": where the refused point stands and why it is refused.
std::string describe(const Refusal& refusal, const PointFile& file, const TriangulateOptions& options) {
  const std::string place = refusal.point < file.lines.size() ? std::to_string(file.lines[refusal.point])
                                                              : "point " + std::to_string(refusal.point);
  return options.points + ":" + place + ": " + options.backend + ": " + refusal.reason;
}

struct Run {
  Triangulation result;
  PredicateCounts counts;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
};

/// What the user chose, by name.
struct Method {
  const PlanarAlgorithm& algorithm;
  Settings settings;
  const BackendEntry& backend;
  Order order;
};

Method method_of(const TriangulateOptions& options) {
  const PlanarAlgorithm& algorithm = algorithm_named(options.algorithm);
  return {algorithm, settings_for(algorithm.about.name, algorithm.parameters, options.settings),
          backend_named(options.backend), order_named(options.order)};
}

/// Triangulates, and has the result of a backend that promises nothing checked. Predicates are counted in a
/// run of its own where somebody wants them, so that counting costs no measured time.
Run run_method(const Method& method, const PointFile& file, const Kernel2& kernel, std::uint64_t seed,
               bool counted) {
  const auto& [algorithm, settings, backend, order_kind] = method;
  Run run;
  const auto order = insertion_order(file.points, order_kind, seed);
  const bench::PeakMemory memory;
  const double start = bench::thread_seconds();
  run.result = tribunal::triangulate(file.points, order, kernel, algorithm, settings, file.values);
  run.seconds = bench::thread_seconds() - start;
  run.peak_bytes = memory.growth();
  if (counted)
    tribunal::triangulate(file.points, order, CountedKernel2(kernel, run.counts), algorithm, settings,
                          file.values);
  if (!backend.about->exact && run.result.outcome == Outcome::ok) {
    const bench::Judgement judgement = bench::judge(file.points, run.result, algorithm.about.promise);
    run.result.outcome = judgement.outcome;
    run.result.reason = judgement.reason;
  }
  return run;
}

json stats_json(const TriangulateOptions& options, const Settings& settings, std::size_t n, const Run& run) {
  const Triangulation& t = run.result;
  const Counters& c = t.counters;
  json history = nullptr;
  if (t.history)
    history = {{"nodes", t.history->nodes},
               {"depth_mean", t.history->depth_mean},
               {"depth_late_mean", t.history->depth_late_mean},
               {"depth_max", t.history->depth_max}};
  return {{"algorithm", options.algorithm},
          {"parameters", settings},
          {"backend", options.backend},
          {"order", options.order},
          {"seed", options.seed},
          {"n", n},
          {"duplicates", t.duplicates.size()},
          {"outcome", to_string(t.outcome)},
          {"reason", t.reason},
          {"dimension", t.dimension},
          {"triangles", t.triangles.size()},
          {"edges", t.edges},
          {"hull", t.hull},
          {"tau", c.tau},
          {"tau_with_ghosts", c.tau_with_ghosts},
          {"created", c.created},
          {"flips", c.flips},
          {"on_edge", c.on_edge},
          {"outside_hull", c.outside_hull},
          {"conflict_tests", c.conflict_tests},
          {"location_steps", c.location_steps},
          {"history", history},
          {"predicates", predicates_json(run.counts)},
          {"digest", to_hex(digest(t.triangles))},
          {"seconds", run.seconds},
          {"peak_bytes", run.peak_bytes}};
}

void print_summary(Console console, const json& stats) {
  std::vector<std::vector<std::string>> rows;
  for (const char* key : {"algorithm", "backend", "n", "duplicates", "outcome", "dimension", "triangles",
                          "hull", "tau", "flips", "digest", "seconds"}) {
    const json& value = stats.at(key);
    rows.push_back({key, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  print_table(console, rows);
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

}  // namespace

int triangulate(const TriangulateOptions& options, Console& console) {
  const Method method = method_of(options);
  check_outputs(options, console);
  const PointFile file = points_of(options);

  Run run;
  const Kernel2Binding bound = method.backend.bind2(file.points);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) {
    run.result.outcome = Outcome::out_of_domain;
    run.result.reason = describe(*refusal, file, options);
  } else {
    const bool counted = console.json || !options.stats.empty();
    run = run_method(method, file, *std::get<0>(bound), options.seed, counted);
  }
  const Triangulation& result = run.result;
  const json stats = stats_json(options, method.settings, file.points.size(), run);

  report_duplicates(file, result, options, console);
  if (!options.stats.empty()) write_text(options.stats, stats.dump(2) + "\n");
  if (console.json) print_json(console, stats);
  if (result.outcome == Outcome::out_of_domain || result.outcome == Outcome::refused_input)
    throw BadInput(result.reason);
  if (result.outcome != Outcome::ok)
    console.log << to_string(result.outcome) << ": " << result.reason << '\n';
  if (result.outcome == Outcome::ok && !options.mesh.empty())
    write_mesh(options.mesh, file.points, result.triangles);
  if (result.outcome == Outcome::ok && !options.picture.empty())
    write_picture(options.picture, file.points, result.triangles);
  const bool piped = options.mesh == "-" || options.stats == "-";
  if (!console.json) print_summary({.out = piped ? console.log : console.out, .log = console.log}, stats);
  return result.outcome == Outcome::ok ? good : judged_bad;
}

}  // namespace tribunal::cli
