#include "bench/fuzz/hunt.hpp"

#include "bench/fuzz/batch.hpp"
#include "bench/fuzz/shrink.hpp"
#include "bench/fuzz/ulps.hpp"
#include "predicates/environment.hpp"

#include <algorithm>
#include <cfenv>
#include <chrono>
#include <stdexcept>

namespace tribunal::bench::fuzz {
namespace {

constexpr std::size_t batch_queries = 256;
constexpr std::size_t pool_candidates = 4;  ///< cases per batch that may go into the pool

std::size_t index_of(Stage stage) { return static_cast<std::size_t>(stage); }

/// Whether moving one coordinate of the last point by at most two ulps makes another stage decide.
bool is_near_threshold(const BoundSubject& bound, const Case& asked, Stage stage) {
  for (int axis = 0; axis < asked.dimension(); ++axis)
    for (const int steps : {-2, -1, 1, 2}) {
      Case moved = asked;
      double& c = moved.point(asked.points() - 1)[axis];
      c = moved_by_ulps(c, steps);
      if (bound.admits(moved) && bound.decide(moved).stage != stage) return true;
    }
  return false;
}

class Hunt {
 public:
  explicit Hunt(const HuntOptions& options)
      : options_(options), oracle_(options.oracle), random_(options.seed) {
    if (const std::string fault = describe_fault(witness_floating_point()); !fault.empty())
      throw std::runtime_error("the oracle cannot be trusted here: " + fault);
    std::fegetenv(&environment_);
    for (const Subject& subject : options.subjects)
      for (const Predicate predicate : options.predicates)
        report_.tallies.push_back({.backend = subject.name, .exact = subject.exact, .predicate = predicate});
  }

  HuntReport run() {
    replay_corpus();
    for (std::uint64_t index = 0; !finished(); ++index) {
      const std::size_t predicate = index % options_.predicates.size();
      const Batch batch =
          draw_batch(options_.seed, index, options_.predicates[predicate], pool_, next_size());
      drawn_ += batch.cases.size();
      ask(batch, predicate);
      remember_hard_cases(batch);
    }
    if (options_.seconds) report_.seconds = elapsed();
    report_.oracle = oracle_.kind();
    report_.asked_gmp = oracle_.asked_gmp();
    report_.rechecked = oracle_.rechecked();
    report_.oracle_faults = oracle_.faults();
    return std::move(report_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  bool finished() const { return interrupted() || (options_.queries && drawn_ >= *options_.queries); }

  /// By the user or the clock, which end a long corpus, too.
  bool interrupted() const { return stopped_ || (options_.seconds && elapsed() >= *options_.seconds); }

  std::size_t next_size() const {
    return options_.queries ? std::min<std::uint64_t>(batch_queries, *options_.queries - drawn_)
                            : batch_queries;
  }

  void replay_corpus() {
    for (const CorpusEntry& entry : options_.corpus) {
      if (interrupted()) return;
      const auto predicate =
          std::find(options_.predicates.begin(), options_.predicates.end(), entry.asked.predicate);
      if (predicate == options_.predicates.end()) continue;
      pool_.add(entry.asked);
      Batch batch{
          .predicate = entry.asked.predicate, .source = "corpus", .cases = {entry.asked}, .parities = {}};
      permute(batch, 2, random_);
      ask(batch, static_cast<std::size_t>(predicate - options_.predicates.begin()));
    }
  }

  void remember_hard_cases(const Batch& batch) {
    const auto drawn = batch.drawn_cases();
    for (const Case& asked : drawn.first(std::min(drawn.size(), pool_candidates)))
      if (certified_sign(asked) == Sign::zero) pool_.add_or_replace(asked, random_);
  }

  /// Asks all subjects. The oracle is asked once, and only when somebody answers.
  void ask(const Batch& batch, std::size_t predicate) {
    std::vector<Sign> truths;
    for (std::size_t s = 0; s < options_.subjects.size(); ++s) {
      const Subject& subject = options_.subjects[s];
      Tally& tally = report_.tallies[s * options_.predicates.size() + predicate];
      const auto binding = bind_subject(subject, batch.drawn_cases());
      restore_environment(subject);
      if (const auto* refusal = std::get_if<Refusal>(&binding)) {
        if (tally.refused == 0) tally.refusal = refusal->reason;
        tally.refused += batch.cases.size();
      } else {
        if (truths.empty()) truths = truths_of(batch);
        compare(subject, std::get<BoundSubject>(binding), batch, truths, tally);
      }
      restore_environment(subject);
    }
    if (!truths.empty()) report_.checked += batch.cases.size();
    if (options_.progress && !options_.progress({report_.checked, wrong_})) stopped_ = true;
  }

  std::vector<Sign> truths_of(const Batch& batch) {
    std::vector<Sign> truths = oracle_.judge(batch.drawn_cases());
    for (std::size_t i = 0; truths.size() < batch.cases.size(); ++i)
      truths.push_back(truths[i] * batch.parities[i]);
    return truths;
  }

  void compare(const Subject& subject, const BoundSubject& bound, const Batch& batch,
               const std::vector<Sign>& truths, Tally& tally) {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < batch.cases.size(); ++i) {
      const Decision decision = bound.decide(batch.cases[i]);
      ++tally.stages[index_of(decision.stage)];
      if (broken_law(bound, batch.cases[i], decision, truths[i])) wrong.push_back(i);
      if (i % threshold_sample == 0 && is_near_threshold(bound, batch.cases[i], decision.stage))
        ++tally.near_threshold[index_of(decision.stage)];
    }
    tally.checked += batch.cases.size();
    tally.wrong += wrong.size();
    wrong_ += wrong.size();
    if (wrong.empty() || tally.counterexample) return;
    const std::size_t simplest = *std::min_element(
        wrong.begin(), wrong.end(),
        [&](std::size_t a, std::size_t b) { return size_of(batch.cases[a]) < size_of(batch.cases[b]); });
    tally.counterexample = {.backend = subject.name,
                            .asked = batch.cases[simplest],
                            .exact = truths[simplest],
                            .source = batch.source,
                            .drawn = drawn_};
    examine(bound, *tally.counterexample);
    shrink_counterexample(subject, *tally.counterexample);
  }

  /// Fills in what the bound subject does with the counterexample; false when it does nothing wrong.
  static bool examine(const BoundSubject& bound, Counterexample& found) {
    const Decision decision = bound.decide(found.asked);
    const auto law = broken_law(bound, found.asked, decision, found.exact);
    if (!law) return false;
    found.got = decision.sign;
    found.stage = decision.stage;
    found.law = *law;
    return true;
  }

  /// Shrinks as long as the subject, bound to nothing but the case, answers wrongly.
  static void shrink_counterexample(const Subject& subject, Counterexample& found) {
    const auto examine_alone = [&](Counterexample& candidate) {
      candidate.exact = exact_sign(candidate.asked);
      const auto binding = bind_subject(subject, std::span(&candidate.asked, 1));
      return std::holds_alternative<BoundSubject>(binding) &&
             examine(std::get<BoundSubject>(binding), candidate);
    };
    const auto fails = [&](const Case& asked) {
      Counterexample candidate{.asked = asked};
      return examine_alone(candidate);
    };
    found.alone = fails(found.asked);
    if (!found.alone) return;
    found.asked = shrink(found.asked, fails);
    examine_alone(found);
  }

  /// An outsider may change the environment, and with it the truth: it is looked at after every batch.
  void restore_environment(const Subject& subject) {
    const std::string fault = describe_fault(witness_floating_point());
    if (fault.empty()) return;
    std::fesetenv(&environment_);
    const std::string breach = subject.name + ": " + fault + " after it was asked";
    if (std::find(report_.breaches.begin(), report_.breaches.end(), breach) == report_.breaches.end())
      report_.breaches.push_back(breach);
  }

  const HuntOptions& options_;
  Oracle oracle_;
  Random random_;  ///< for the pool; batches have their own
  Pool pool_;
  HuntReport report_;
  std::fenv_t environment_{};
  Clock::time_point start_ = Clock::now();
  std::uint64_t drawn_ = 0, wrong_ = 0;
  bool stopped_ = false;
};

}  // namespace

std::optional<Law> broken_law(const BoundSubject& bound, const Case& asked, const Decision& decision,
                              Sign exact) {
  if (decision.stage != Stage::symbolic)
    return decision.sign == exact ? std::nullopt : std::optional(Law::truth);
  if (exact != Sign::zero) return Law::truth;
  for (int i = 1; i < asked.points(); ++i) {
    Case swapped = asked;
    swapped.swap_points(i - 1, i);
    if (bound.decide(swapped).sign != -decision.sign) return Law::antisymmetry;
  }
  return std::nullopt;
}

HuntReport hunt(const HuntOptions& options) { return Hunt(options).run(); }

}  // namespace tribunal::bench::fuzz
