// tribunal triangulate: the user's points to a mesh.
#include "algorithms/triangulate.hpp"

#include "algorithms/mesh/canonical.hpp"
#include "bench/measure.hpp"
#include "cli/lookup.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/picture.hpp"
#include "datasets/files/text.hpp"
#include "predicates/counted.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace tribunal::cli {
namespace {
using nlohmann::json;

/// A file, standard input ("-"), or, where no such file is, a dataset of that name.
PointFile points_of(const TriangulateOptions& options) {
  if (options.points != "-" && !std::filesystem::exists(options.points))
    if (const Dataset* dataset = find_dataset(options.points)) {
      PointFile file;
      file.points = generate(*dataset, options.n, options.seed);
      return file;
    }
  return read_points(options.points);
}

/// "coast.xy:17: knuth: ...": where the refused point stands and why it is refused.
std::string describe(const Refusal& refusal, const PointFile& file, const TriangulateOptions& options) {
  const std::string place = refusal.point < file.lines.size() ? std::to_string(file.lines[refusal.point])
                                                              : "point " + std::to_string(refusal.point);
  return options.points + ":" + place + ": " + options.backend + ": " + refusal.reason;
}

json predicates_json(const PredicateCounts& counts) {
  json predicates = json::object();
  for (std::size_t p = 0; p < predicate_names.size(); ++p) {
    const auto predicate = static_cast<Predicate>(p);
    if (counts.total(predicate) == 0) continue;
    json stages = json::object();
    for (std::size_t s = 0; s < stage_names.size(); ++s)
      if (const auto calls = counts.at(predicate, static_cast<Stage>(s)))
        stages[std::string(stage_names[s])] = calls;
    predicates[std::string(predicate_names[p])] = {{"calls", counts.total(predicate)}, {"stages", stages}};
  }
  return predicates;
}

struct Cost {
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
};

json stats_json(const TriangulateOptions& options, std::size_t n, const Triangulation& t, const Cost& cost,
                const PredicateCounts& counts) {
  const Counters& c = t.counters;
  json history = nullptr;
  if (t.history)
    history = {{"nodes", t.history->nodes},
               {"depth_mean", t.history->depth_mean},
               {"depth_late_mean", t.history->depth_late_mean},
               {"depth_max", t.history->depth_max}};
  return {{"algorithm", options.algorithm},
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
          {"predicates", predicates_json(counts)},
          {"digest", to_hex(digest(t.triangles))},
          {"seconds", cost.seconds},
          {"peak_bytes", cost.peak_bytes}};
}

void print_summary(Console& console, const json& stats) {
  std::vector<std::vector<std::string>> rows;
  for (const char* key : {"algorithm", "backend", "n", "duplicates", "outcome", "dimension", "triangles",
                          "hull", "tau", "flips", "digest", "seconds"}) {
    const json& value = stats.at(key);
    rows.push_back({key, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  print_table(console, rows);
}

}  // namespace

int triangulate(const TriangulateOptions& options, Console& console) {
  const PlanarAlgorithm& algorithm = algorithm_named(options.algorithm);
  const BackendEntry& backend = backend_named(options.backend);
  const Order order_kind = order_named(options.order);
  const PointFile file = points_of(options);
  const Kernel2Binding bound = backend.bind2(file.points);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) throw BadInput(describe(*refusal, file, options));
  const Kernel2& kernel = *std::get<0>(bound);
  const auto order = insertion_order(file.points, order_kind, options.seed);

  const bench::PeakMemory memory;
  const double start = bench::thread_seconds();
  const Triangulation result = tribunal::triangulate(file.points, order, kernel, algorithm);
  const Cost cost{bench::thread_seconds() - start, memory.growth()};

  PredicateCounts counts;  // in a run of its own, so that counting costs no measured time
  if (console.json || !options.stats.empty())
    tribunal::triangulate(file.points, order, CountedKernel2(kernel, counts), algorithm);
  const json stats = stats_json(options, file.points.size(), result, cost, counts);

  for (const auto& [repeated, first] : result.duplicates)
    if (!file.lines.empty() && result.duplicates.size() <= 10)
      console.log << options.points << ':' << file.lines[repeated] << ": the same point as line "
                  << file.lines[first] << ", merged\n";
  if (result.duplicates.size() > 10) console.log << result.duplicates.size() << " duplicate points merged\n";
  if (result.outcome != Outcome::ok)
    console.log << to_string(result.outcome) << ": " << result.reason << '\n';

  if (result.outcome == Outcome::ok && !options.mesh.empty())
    write_mesh(options.mesh, file.points, result.triangles);
  if (result.outcome == Outcome::ok && !options.picture.empty())
    write_picture(options.picture, file.points, result.triangles);
  if (!options.stats.empty()) write_text(options.stats, stats.dump(2) + "\n");
  if (console.json)
    print_json(console, stats);
  else
    print_summary(console, stats);
  if (result.outcome == Outcome::ok) return good;
  return result.outcome == Outcome::refused_input ? bad_input : judged_bad;
}

}  // namespace tribunal::cli
