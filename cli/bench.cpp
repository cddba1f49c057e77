// tribunal bench predicates: micro timings side by side, and the ratios that are aimed at.
#include "bench/interrupt.hpp"
#include "bench/micro/goals.hpp"
#include "bench/micro/predicate_bench.hpp"
#include "bench/outsider/printable.hpp"
#include "bench/sound_environment.hpp"
#include "cli/bench_document.hpp"
#include "cli/lookup.hpp"
#include "cli/own_output.hpp"
#include "cli/peers.hpp"
#include "cli/progress.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "predicates/plugin/library.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

namespace tribunal::cli {
namespace {

std::vector<Predicate> chosen_predicates(const std::vector<std::string>& names) {
  if (names.empty()) return {all_predicates.begin(), all_predicates.end()};
  std::vector<Predicate> chosen;
  for (const std::string& name : each_once(names)) chosen.push_back(predicate_named(name));
  return chosen;
}

std::vector<const QueryFamily*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const QueryFamily*> chosen;
  for (const std::string& name : each_once(names)) chosen.push_back(&query_family_named(name));
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
  for (const std::string& name : each_once(names)) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& subject) { return subject.name == name; });
    if (found == all.end())
      throw BadUsage("there is no backend '" + name + "'; there are those of tribunal list backends and " +
                     all.back().name);
    chosen.push_back(*found);
  }
  return chosen;
}

/// Refuses options of the other half: who gives one expects it to count.
void refuse_what_is_not_asked(const BenchOptions& o) {
  const bool algorithms = o.what == "algorithms";
  const std::pair<const char*, bool> others[] = {{"--predicate", algorithms && !o.predicates.empty()},
                                                 {"--family", algorithms && !o.families.empty()},
                                                 {"--algorithm", !algorithms && !o.algorithms.empty()},
                                                 {"--set", !algorithms && !o.settings.empty()},
                                                 {"--order", !algorithms && !o.orders.empty()},
                                                 {"--dataset", !algorithms && !o.datasets.empty()},
                                                 {"-n", !algorithms && o.n != 0}};
  for (const auto& [name, given] : others)
    if (given)
      throw BadUsage(std::string(name) + " goes with bench " + (algorithms ? "predicates" : "algorithms"));
}

/// The modules of peers with predicates, under printable names that nobody else has.
void add_peers(bench::PredicateBenchOptions& plan, Console& console) {
  const auto peers = built_peers();
  if (peers.empty()) console.log << "no peers: none was built beside the program\n";
  for (const auto& [name, module] : peers) {
    const bench::SoundEnvironment environment;
    std::optional<bench::Subject> peer = bench::plugin_subject(module.string());
    const std::string fault = environment.restore();
    if (!peer) continue;
    peer->name = bench::printable(peer->name);
    if (std::ranges::find(plan.subjects, peer->name, &bench::Subject::name) != plan.subjects.end())
      peer->name += " (" + std::string(name) + ")";
    if (!fault.empty()) plan.faults[peer->name] = fault + " after it was loaded";
    plan.subjects.push_back(std::move(*peer));
  }
}

}  // namespace

int bench(const BenchOptions& options, Console& console) try {
  if (options.what != "predicates" && options.what != "algorithms")
    throw BadUsage("bench what? predicates or algorithms, not '" + options.what + "'");
  refuse_what_is_not_asked(options);
  if (options.what == "algorithms") return bench_algorithms(options, console);
  bench::PredicateBenchOptions plan;
  plan.subjects = chosen_subjects(options.backends);
  plan.predicates = chosen_predicates(options.predicates);
  plan.families = chosen_families(options.families);
  plan.queries = options.queries;
  plan.seed = options.seed;
  plan.stopwatch.rounds = options.repetitions.value_or(21);
  plan.progress = progress_printer(console);
  std::optional<OwnOutput> output;
  if (options.peers) {
    output.emplace();
    add_peers(plan, console);
  }
  bench::Interrupt interrupt;
  plan.interrupted = [&interrupt] { return interrupt.requested(); };
  const std::vector<bench::MicroCell> cells = bench_predicates(plan);
  const auto goals = measure_goals(bench::goals(), cells);
  const auto print = [&] {
    if (console.json)
      print_json(console, bench_document(plan, cells, goals));
    else
      print_bench(console, plan, cells, goals);
  };
  output ? output->print(console, print) : print();
  const std::size_t asked = plan.subjects.size() * plan.predicates.size() * plan.families.size();
  if (cells.size() < asked) {
    console.log << "interrupted: these are the families that were measured\n";
    return judged_bad;
  }
  return std::ranges::any_of(cells, &bench::MicroCell::broke_promise) ? judged_bad : good;
} catch (const PluginError& error) {
  throw BadInput(error.what());
}

}  // namespace tribunal::cli
