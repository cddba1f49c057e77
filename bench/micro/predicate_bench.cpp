#include "bench/micro/predicate_bench.hpp"

#include "bench/sound_environment.hpp"

#include <chrono>

namespace tribunal::bench {
namespace {

using Loops = std::vector<std::unique_ptr<const SignLoop>>;

/// Counts wrong signs and deciding stages over all queries.
void check(const SignLoop& loop, std::span<const Sign> truth, MicroCell& cell) {
  std::vector<Decision> decisions(truth.size());
  loop.decide(decisions);
  cell.queries = truth.size();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    cell.wrong += decisions[i].sign != truth[i];
    ++cell.stages[static_cast<std::size_t>(decisions[i].stage)];
  }
  cell.outcome = cell.wrong == 0 ? MicroOutcome::timed : MicroOutcome::wrong_signs;
}

/// Binds and checks one subject; null where there is nothing to be timed.
std::unique_ptr<const SignLoop> check_subject(const Subject& subject, const QuerySet& queries,
                                              std::span<const Sign> truth, MicroCell& cell) {
  SignLoopBinding bound = subject.bind(queries);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) {
    cell.reason = refusal->reason;
    return nullptr;
  }
  check(*std::get<0>(bound), truth, cell);
  cell.broke_promise = subject.promises_exactness && cell.wrong != 0;
  return cell.wrong == 0 ? std::get<0>(std::move(bound)) : nullptr;
}

/// loops[i] is null where there is nothing to be timed.
std::vector<MicroCell> check_all(const PredicateBenchOptions& options, const QuerySet& queries,
                                 std::string_view family, Loops& loops) {
  const SoundEnvironment environment;
  const std::vector<Sign> truth = exact_signs(queries);
  std::vector<MicroCell> cells;
  for (const Subject& subject : options.subjects) {
    MicroCell& cell = cells.emplace_back();
    cell.subject = subject.name;
    cell.predicate = queries.predicate;
    cell.family = family;
    auto& loop = loops.emplace_back();
    if (const auto found = options.faults.find(subject.name); found != options.faults.end()) {
      cell.accuse(found->second);
      continue;
    }
    loop = check_subject(subject, queries, truth, cell);
    if (const std::string fault = environment.restore(); !fault.empty()) {
      cell.accuse(fault + " after it was asked");
      loop.reset();
      environment.restore();
    }
  }
  return cells;
}

/// Nanoseconds of every loop, and the faults of those that were found out only now.
std::vector<std::vector<double>> time_all(std::span<const SignLoop* const> timed, std::size_t queries,
                                          StopwatchOptions stopwatch,
                                          std::map<const SignLoop*, std::string>& faults) {
  const SoundEnvironment environment;
  stopwatch.after = [&](const SignLoop& loop) {
    if (std::string fault = environment.restore(); !fault.empty()) faults.emplace(&loop, std::move(fault));
  };
  return time_side_by_side(timed, queries, stopwatch);
}

std::vector<MicroCell> bench_family(const PredicateBenchOptions& options, Predicate predicate,
                                    const QueryFamily& family) {
  const QuerySet queries = draw_query_set(family, predicate, options.queries, options.seed);
  Loops loops;
  std::vector<MicroCell> cells = check_all(options, queries, family.name, loops);
  std::vector<const SignLoop*> timed;
  for (const auto& loop : loops)
    if (loop) timed.push_back(loop.get());
  std::map<const SignLoop*, std::string> faults;
  StopwatchOptions stopwatch = options.stopwatch;
  stopwatch.interrupted = options.interrupted;
  auto times = time_all(timed, queries.count, stopwatch, faults);
  const SoundEnvironment environment;
  auto next = times.begin();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!loops[i]) continue;
    cells[i].nanoseconds = std::move(*next++);
    if (const auto found = faults.find(loops[i].get()); found != faults.end())
      cells[i].accuse(found->second + " while it was timed");
    loops[i].reset();
    if (const std::string fault = environment.restore(); !fault.empty())
      cells[i].accuse(fault + " after it was released");
  }
  return cells;
}

}  // namespace

std::vector<MicroCell> bench_predicates(const PredicateBenchOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Progress progress;
  progress.total = options.predicates.size() * options.families.size();
  std::vector<MicroCell> all;
  for (const Predicate predicate : options.predicates)
    for (const QueryFamily* family : options.families) {
      for (MicroCell& cell : bench_family(options, predicate, *family)) {
        progress.failures += cell.broke_promise;
        all.push_back(std::move(cell));
      }
      ++progress.done;
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      progress.seconds_left = elapsed.count() * static_cast<double>(progress.total - progress.done) /
                              static_cast<double>(progress.done);
      if (options.progress) options.progress(progress);
      if (options.interrupted && options.interrupted()) return all;
    }
  return all;
}

}  // namespace tribunal::bench
