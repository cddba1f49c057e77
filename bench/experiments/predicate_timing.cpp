// Experiment `predicate-timing`: what a query costs a backend, where all its signs are right.
//
// n queries of a family (datasets/queries/queries.hpp) to one predicate, checked against exact integers; see
// bench/micro/predicate_bench.hpp. Samples are of thread CPU time for all n queries; a backend with a wrong
// sign has none. Backends in cells of their own are not measured side by side: `tribunal bench predicates`
// compares.
//
// Counters: `queries`, `wrong`, and `stage.*`, the queries decided by each stage.
#include "bench/experiments/listed.hpp"
#include "bench/experiments/name_parameters.hpp"
#include "bench/micro/predicate_bench.hpp"

#include <array>

namespace tribunal::bench {
namespace {

constexpr Parameter family_parameter{
    .name = "family", .summary = "how the queries are drawn", .standard = "uni", .choices = [] {
      std::vector<std::string_view> names;
      for (const QueryFamily& family : query_families()) names.push_back(family.name);
      return names;
    }};
constexpr std::array parameters{predicate_parameter, family_parameter};

/// Nothing where the backend is none that is timed: one that breaks ties asks another first.
std::vector<MicroCell> time_one(const Cell& cell) {
  PredicateBenchOptions options;
  for (Subject& subject : backend_subjects())
    if (subject.name == cell.backend) options.subjects.push_back(std::move(subject));
  options.predicates = {chosen_predicate(cell)};
  options.families = {find_query_family(choice(cell.parameters, family_parameter))};
  options.queries = cell.n;
  options.seed = cell.seed;
  return bench_predicates(options);
}

Finding run_predicate_timing(const Cell& cell) {
  const std::vector<MicroCell> cells = time_one(cell);
  if (cells.empty()) return {Outcome::refused_input, cell.backend + " is not timed"};
  const MicroCell& timed = cells[0];
  if (timed.outcome == MicroOutcome::out_of_domain) return {Outcome::out_of_domain, timed.reason};
  Finding finding;
  finding.counters["queries"] = static_cast<double>(timed.queries);
  finding.counters["wrong"] = static_cast<double>(timed.wrong);
  for (std::size_t s = 0; s < timed.stages.size(); ++s)
    if (timed.stages[s] != 0)
      finding.counters["stage." + std::string(stage_names[s])] = static_cast<double>(timed.stages[s]);
  for (const double nanoseconds : timed.nanoseconds)
    finding.seconds.push_back(nanoseconds * 1e-9 * static_cast<double>(cell.n));
  return finding;
}

}  // namespace

constinit const Experiment predicate_timing_experiment{
    .name = "predicate-timing",
    .cites = "this project",
    .summary = "time of n queries of a family to one predicate, where all signs are right",
    .reads = {.backend = true, .n = true, .seed = true},
    .parameters = parameters,
    .run = run_predicate_timing,
};

}  // namespace tribunal::bench
