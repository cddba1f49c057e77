// tribunal bench predicates: micro timings side by side, and the ratios that are aimed at.
#include "bench/micro/goals.hpp"
#include "bench/micro/predicate_bench.hpp"
#include "cli/bench_document.hpp"
#include "cli/lookup.hpp"
#include "cli/peers.hpp"
#include "cli/progress.hpp"
#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace tribunal::cli {
namespace {

std::vector<Predicate> chosen_predicates(const std::vector<std::string>& names) {
  if (names.empty()) return {all_predicates.begin(), all_predicates.end()};
  std::vector<Predicate> chosen;
  for (const std::string& name : names) chosen.push_back(predicate_named(name));
  return chosen;
}

std::vector<const QueryFamily*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const QueryFamily*> chosen;
  for (const std::string& name : names) chosen.push_back(&query_family_named(name));
  if (names.empty())
    for (const QueryFamily& family : query_families()) chosen.push_back(&family);
  return chosen;
}

/// All backends and the batch, or those that were named.
std::vector<bench::Subject> chosen_subjects(const std::vector<std::string>& names) {
  std::vector<bench::Subject> all = bench::backend_subjects();
  all.push_back(bench::batch_subject());
  if (names.empty()) return all;
  std::vector<bench::Subject> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& subject) { return subject.name == name; });
    if (found == all.end())
      throw BadUsage("there is no backend '" + name + "'; there are those of tribunal list backends and " +
                     all.back().name);
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace

int bench(const BenchOptions& options, Console& console) {
  if (options.what == "algorithms") return bench_algorithms(options, console);
  if (options.what != "predicates")
    throw BadUsage("bench what? predicates or algorithms, not '" + options.what + "'");
  bench::PredicateBenchOptions plan{.subjects = chosen_subjects(options.backends),
                                    .predicates = chosen_predicates(options.predicates),
                                    .families = chosen_families(options.families),
                                    .queries = options.queries,
                                    .seed = options.seed,
                                    .stopwatch = {.rounds = options.repetitions.value_or(21)},
                                    .progress = progress_printer(console)};
  if (options.peers) {
    for (const auto& [name, module] : built_peers())
      plan.subjects.push_back(bench::plugin_subject(module.string()));
    if (built_peers().empty()) console.log << "no peers: none was built beside the program\n";
  }
  const std::vector<bench::MicroCell> cells = bench_predicates(plan);
  const auto goals = measure_goals(bench::goals(), cells);
  if (console.json)
    print_json(console, bench_document(plan, cells, goals));
  else
    print_bench(console, plan, cells, goals);
  const bool promises_kept =
      std::none_of(cells.begin(), cells.end(), [](const auto& cell) { return cell.broke_promise; });
  return promises_kept ? good : judged_bad;
}

}  // namespace tribunal::cli
