// tribunal bench algorithms: whole runs side by side, from points to triangles.
#include "algorithms/abandon.hpp"
#include "bench/whole/race.hpp"
#include "cli/heats.hpp"
#include "cli/lookup.hpp"
#include "cli/peers.hpp"
#include "cli/progress.hpp"
#include "cli/race_report.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace tribunal::cli {
namespace {

/// The peers that can take part in a heat.
std::vector<bench::Contestant> peers_at(bench::RaceKind kind, Console& console) {
  std::vector<bench::Contestant> peers;
  for (const auto& [name, module] : built_peers())
    if (auto peer = bench::peer_contestant(module.string(), kind)) peers.push_back(std::move(*peer));
  if (peers.empty())
    console.log << "no peers for races of kind " << to_string(kind)
                << ": none was built beside the program\n";
  return peers;
}

std::vector<bench::Standing> run(const Heat& heat, const BenchOptions& options, Console& console) {
  bench::RaceOptions plan;
  plan.course = heat.course;
  plan.seed = options.seed;
  plan.limits.seconds = options.seconds;
  plan.progress = progress_printer(console);
  if (options.repetitions) plan.rounds = *options.repetitions;
  for (const bench::Method& method : heat.methods)
    plan.contestants.push_back(contestant_of(method, heat.course.kind, options.seed));
  if (options.peers) {
    const auto peers = peers_at(heat.course.kind, console);
    plan.contestants.insert(plan.contestants.end(), peers.begin(), peers.end());
  }
  return race(plan);
}

}  // namespace

int bench_algorithms(const BenchOptions& options, Console& console) try {
  std::vector<bench::Standing> standings;
  std::vector<Comparison> comparisons;
  for (const Heat& heat : heats_of(options)) {
    const std::vector<bench::Standing> came = run(heat, options, console);
    const std::vector<Comparison> made = compare(came, heat.methods.size());
    standings.insert(standings.end(), came.begin(), came.end());
    comparisons.insert(comparisons.end(), made.begin(), made.end());
  }
  if (console.json)
    print_json(console, races_document(options.seed, standings, comparisons));
  else
    print_races(console, standings, comparisons);
  const bool sound = std::all_of(standings.begin(), standings.end(),
                                 [](const bench::Standing& s) { return s.ruling.stands(); });
  return sound ? good : judged_bad;
} catch (const Abandon& abandon) {
  throw BadInput(abandon.what());
}

}  // namespace tribunal::cli
