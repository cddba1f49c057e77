#include "bench/micro/stopwatch.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace tribunal::bench {
namespace {

/// How a loop is run for one value.
struct Pass {
  const SignLoop* loop;
  std::size_t queries;  ///< the first so many
  std::int64_t repeats;
};

/// Keeps the times and prints nothing.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      nanoseconds.push_back(run.cpu_accumulated_time * 1e9 / static_cast<double>(run.iterations));
  }
  std::vector<double> nanoseconds;  ///< of one repeat of each pass
};

/// Nanoseconds per query of each pass, run in the order given.
std::vector<double> run_passes(std::span<const Pass> passes, std::span<Sign> signs,
                               const StopwatchOptions& options) {
  if (passes.empty()) return {};
  for (const Pass& pass : passes)
    benchmark::RegisterBenchmark("pass", [&pass, &options, signs](benchmark::State& state) {
      // What takes as long as its coordinates take to arrive starts with them in the caches, whoever ran
      // before.
      if (pass.repeats > 1) pass.loop->sign(signs.first(pass.queries));
      for ([[maybe_unused]] auto repeat : state) {
        pass.loop->sign(signs.first(pass.queries));
        benchmark::ClobberMemory();
      }
      if (options.after) options.after(*pass.loop);
    })->Iterations(pass.repeats);
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector, "all");
  benchmark::ClearRegisteredBenchmarks();
  std::vector<double> per_query;
  for (std::size_t i = 0; i < passes.size(); ++i)
    per_query.push_back(collector.nanoseconds.at(i) / static_cast<double>(passes[i].queries));
  return per_query;
}

/// As many queries and repeats as take the time wanted, by a first pass over a few queries that also warms
/// up.
std::vector<Pass> plan_passes(std::span<const SignLoop* const> loops, std::size_t queries,
                              const StopwatchOptions& options, std::span<Sign> signs) {
  const std::size_t few = std::min<std::size_t>(queries, 1024);
  std::vector<Pass> passes;
  for (const SignLoop* loop : loops) passes.push_back({loop, few, 1});
  const std::vector<double> estimates = run_passes(passes, signs, options);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double wanted = options.milliseconds * 1e6 / std::max(estimates[i], 0.1);  // queries
    passes[i].queries = std::clamp(static_cast<std::size_t>(wanted), few, queries);
    passes[i].repeats = std::max<std::int64_t>(1, std::llround(wanted / static_cast<double>(queries)));
  }
  return passes;
}

}  // namespace

std::vector<std::vector<double>> time_side_by_side(std::span<const SignLoop* const> loops,
                                                   std::size_t queries, const StopwatchOptions& options) {
  std::vector<Sign> signs(queries);
  std::vector<Pass> passes = plan_passes(loops, queries, options, signs);
  std::vector<std::vector<double>> times(loops.size());
  for (int round = 0; round < options.rounds; ++round) {
    std::vector<double> values = run_passes(passes, signs, options);
    if (round % 2 != 0) std::reverse(values.begin(), values.end());
    for (std::size_t i = 0; i < values.size(); ++i) times[i].push_back(values[i]);
    std::reverse(passes.begin(), passes.end());
    if (options.interrupted && options.interrupted()) break;
  }
  return times;
}

}  // namespace tribunal::bench
