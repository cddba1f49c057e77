// tribunal optimize: a user's mesh, made better.
#include "algorithms/abandon.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/optimizers.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/judge.hpp"
#include "bench/measure.hpp"
#include "cli/lookup.hpp"
#include "cli/mesh_input.hpp"
#include "cli/outputs.hpp"
#include "cli/picture.hpp"
#include "cli/predicate_counts.hpp"
#include "cli/statistics.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/pslg.hpp"

#include <array>
#include <ostream>

namespace tribunal::cli {
namespace {
/// A user's mesh over a user's points.
struct MeshInput {
  PointFile points;
  MeshFile mesh;
};

using nlohmann::json;

/// Flips take a triangulation for granted: anything else is refused, with its first fault.
void require_triangulation(const OptimizeOptions& options, const MeshInput& input) {
  const auto verdict =
      tribunal::verify::verify_planar(input.points.points, {.triangles = input.mesh.triangles},
                                      {.kind = tribunal::verify::Kind::triangulation, .max_faults = 1});
  if (!verdict.valid())
    throw BadInput(options.mesh + ": is no triangulation of " + options.points + ": " +
                   std::string(tribunal::verify::to_string(verdict.faults[0].kind)) + ", " +
                   verdict.faults[0].detail);
}

struct Improvement {
  OptimizedMesh mesh;
  Outcome outcome = Outcome::ok;
  std::string reason;
  PredicateCounts predicates;
  double seconds = 0;
};

/// Predicates are counted in a run of its own, so that counting costs no measured time.
Improvement improve(const MeshInput& input, const Kernel2& kernel, const MeshOptimizer& optimizer,
                    const Settings& settings, bool counted) {
  Improvement result;
  MeshProblem problem{{input.points.points, kernel}, input.mesh.triangles, input.points.values, settings};
  try {
    const double start = bench::thread_seconds();
    result.mesh = optimizer.run(problem);
    result.seconds = bench::thread_seconds() - start;
    if (!counted) return result;
    const CountedKernel2 counting(kernel, result.predicates);
    optimizer.run({{input.points.points, counting}, problem.triangles, problem.values, settings});
  } catch (const Abandon& abandon) {
    result.outcome = abandon.outcome;
    result.reason = abandon.what();
  }
  return result;
}

/// What signs without a promise have made.
void check(std::span<const Point2> points, Improvement& result) {
  if (result.outcome != Outcome::ok) return;
  Triangulation mesh;
  mesh.dimension = result.mesh.triangles.empty() ? 1 : 2;
  mesh.triangles = result.mesh.triangles;
  const bench::Judgement judgement = bench::judge(points, mesh, Promise::triangulation);
  result.outcome = judgement.outcome;
  result.reason = judgement.reason;
}

TableRows summary(const json& stats) {
  constexpr std::array keys{"criterion", "backend", "n", "triangles", "outcome"};
  TableRows rows = rows_of(stats, keys);
  for (const auto& [name, value] : stats.at("counts").items()) rows.push_back({name, plain_text(value)});
  for (const char* which : {"largest", "smallest"})
    rows.push_back({std::string(which) + " angle", plain_text(stats.at("angles_before").at(which)) + " -> " +
                                                       plain_text(stats.at("angles_after").at(which))});
  return rows;
}

}  // namespace

int optimize(const OptimizeOptions& options, Console& console) {
  const MeshOptimizer& optimizer = optimizer_named(options.criterion);
  const Settings settings = settings_for(optimizer.name, optimizer.parameters, options.settings);
  const BackendEntry& backend = backend_named(options.backend);
  check_picture(options.picture);
  check_outputs({.inputs = {options.points, options.mesh, options.picture.against},
                 .mesh = options.output,
                 .stats = options.stats,
                 .picture = options.picture.file},
                console);
  if (const auto graph = read_pslg(options.points); graph && !graph->segments.empty())
    throw BadUsage(options.points + " holds segments, which flips would lose: give the points alone");
  MeshInput input{read_points(options.points), {}};
  input.mesh = read_mesh_over(options.points, input.points, options.mesh);
  if (optimizer.reads_values && input.points.values.empty())
    throw BadInput(options.points + ": criterion " + options.criterion +
                   " reads data values from the third column, and there is none");
  const Picture picture(options.picture, options.points, input.points, settings);
  require_triangulation(options, input);
  const Kernel2Binding bound = backend.bind2(input.points.points);
  if (const auto* refusal = std::get_if<Refusal>(&bound))
    throw BadInput(options.points + ":" + std::to_string(input.points.lines[refusal->point]) + ": " +
                   options.backend + ": " + refusal->reason);

  const Kernel2& kernel = *std::get<0>(bound);
  const bool counted = console.json || !options.stats.empty();
  Improvement result = improve(input, kernel, optimizer, settings, counted);
  if (!backend.about->exact) check(input.points.points, result);
  const bool good_mesh = result.outcome == Outcome::ok;
  json stats{{"criterion", options.criterion},
             {"parameters", settings},
             {"backend", options.backend},
             {"n", input.points.points.size()},
             {"triangles", input.mesh.triangles.size()},
             {"outcome", to_string(result.outcome)},
             {"reason", result.reason},
             {"counts", json::object()},
             {"angles_before", angles_json(input.points.points, input.mesh.triangles)},
             {"angles_after", angles_json(input.points.points, result.mesh.triangles)},
             {"predicates", predicates_json(result.predicates)},
             {"digest", to_hex(digest(result.mesh.triangles))},
             {"seconds", result.seconds}};
  for (const auto& [name, value] : result.mesh.counts) stats["counts"][std::string(name)] = value;

  if (!good_mesh) console.log << to_string(result.outcome) << ": " << result.reason << '\n';
  if (good_mesh && !options.output.empty())
    write_mesh(options.output, input.points.points, result.mesh.triangles);
  if (good_mesh) picture.draw(input.points.points, result.mesh.triangles);
  tell(stats, summary(stats), options.output, options.stats, console);
  return good_mesh ? good : judged_bad;
}

}  // namespace tribunal::cli
