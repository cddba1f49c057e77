#include "bench/outsider/predicate_trial.hpp"

#include "bench/fuzz/batch.hpp"
#include "bench/outsider/replay.hpp"
#include "bench/outsider/testimony.hpp"
#include "datasets/queries/queries.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal::bench {
namespace {
using fuzz::Case;

/// How many queries of one kind the fuzzer draws at a time: the plug-in is bound to each batch by itself, so
/// that one with a narrow domain gets its share.
constexpr std::uint64_t batch_size = 250;

template <int D>
std::vector<Case> cases_of(Predicate predicate, const std::vector<Point<D>>& points) {
  const auto each = static_cast<std::size_t>(points_of(predicate));
  std::vector<Case> cases(points.size() / each, Case{.predicate = predicate});
  for (std::size_t i = 0; i < points.size(); ++i)
    std::ranges::copy(points[i].coordinate, cases[i / each].point(static_cast<int>(i % each)).begin());
  return cases;
}

std::vector<Case> draw(const QueryFamily& family, Predicate predicate, const TrialOptions& options) {
  return dimension_of(predicate) == 2
             ? cases_of<2>(predicate, draw_queries2(family, predicate, options.queries, options.seed))
             : cases_of<3>(predicate, draw_queries3(family, predicate, options.queries, options.seed));
}

/// One predicate of one plug-in.
class PredicateTrial {
 public:
  PredicateTrial(const std::string& path, Predicate predicate, const TrialOptions& options,
                 TrialResult& result)
      : path_(path), predicate_(predicate), options_(options), result_(result) {}

  /// A whole input at once.
  const Exercise& exercise(std::string_view input, std::vector<Case> cases) {
    Exercise exercise = blank(input);
    ask(std::move(cases), exercise);
    return finish(std::move(exercise));
  }

  /// What the fuzzer draws, batch by batch up to the first failure; right when no batch fails and not all are
  /// refused.
  const Exercise& exercise_fuzz() {
    Exercise all = blank("fuzz");
    const fuzz::Pool nothing_to_mutate;
    for (std::uint64_t i = 0; all.n < options_.queries && !failed(all.finding) && !interrupted_; ++i) {
      Exercise one = blank(all.input);
      ask(fuzz::draw_batch(options_.seed, i, predicate_, nothing_to_mutate, batch_size).cases, one);
      one.n += all.n;
      one.seconds = 0;  // of a mixture it would mean nothing
      if (interrupted_ || one.finding != Finding::refused || all.finding == Finding::untried)
        all = std::move(one);
      else
        all.n = one.n;
    }
    return finish(std::move(all));
  }

 private:
  Exercise blank(std::string_view input) const {
    return {.task = std::string(to_string(predicate_)), .input = std::string(input), .reason = {}};
  }

  const Exercise& finish(Exercise exercise) {
    hung_ |= exercise.finding == Finding::hang;
    return result_.exercises.emplace_back(std::move(exercise));
  }

  /// In a child of its own. A predicate that has hung is not asked again.
  void ask(std::vector<Case> cases, Exercise& exercise) {
    exercise.n = cases.size();
    if (hung_) {
      exercise.reason = "it hung before";
      return;
    }
    const Examination examination = examine(std::move(cases));
    const Hearing hearing = hear(path_, examination, options_.limits, options_.wake);
    if (hearing.interrupted) {
      exercise.reason = interrupted_reason;
      interrupted_ = true;
      return;
    }
    exercise.finding = finding_of(hearing.ending.outcome);
    if (hearing.testimony)
      judge(examination, *hearing.testimony, exercise);
    else
      report_death(examination, hearing, exercise);
  }

  void report_death(const Examination& examination, const Hearing& hearing, Exercise& exercise) {
    exercise.reason = hearing.ending.reason + ", " + hearing.place;
    if (!hearing.query) return;
    accuse(exercise, examination.cases[*hearing.query], examination.exact[*hearing.query],
           std::string(to_string(exercise.finding)));
  }

  void judge(const Examination& examination, const Testimony& testimony, Exercise& exercise) {
    if (!testimony.refusal.empty()) {
      exercise.finding = Finding::refused;
      exercise.reason = testimony.refusal;
    } else if (testimony.wrong > 0) {
      exercise.finding = Finding::wrong;
      exercise.wrong = testimony.wrong;
      exercise.reason = std::to_string(testimony.wrong) + " wrong signs";
      accuse_wrong(exercise, {examination.cases[testimony.first],
                              examination.exact[testimony.first],
                              static_cast<Sign>(testimony.got),
                              {}});
    } else if (!testimony.breach.empty()) {
      exercise.finding = Finding::wrong;
      exercise.reason = testimony.breach;
    } else {
      exercise.seconds = testimony.seconds;
    }
  }

  void accuse_wrong(const Exercise& exercise, const WrongSign& found) {
    const WrongSign shown = simplify(path_, found.asked, options_.limits, options_.wake).value_or(found);
    accuse(exercise, shown.asked, shown.exact, std::string(1, to_char(shown.got)), shown.picture);
  }

  void accuse(const Exercise& exercise, const Case& asked, Sign exact, std::string got,
              std::string picture = {}) {
    Counterexample example{.task = exercise.task,
                           .input = exercise.input,
                           .finding = exercise.finding,
                           .points = {},
                           .exact = std::string(1, to_char(exact)),
                           .got = std::move(got),
                           .replay = replay_query("--plugin " + shell_word(path_), asked),
                           .triangles = {},
                           .picture = std::move(picture)};
    for (int i = 0; i < asked.points(); ++i)
      example.points.emplace_back(asked.point(i).begin(), asked.point(i).end());
    result_.counterexamples.push_back(std::move(example));
  }

  const std::string& path_;
  Predicate predicate_;
  const TrialOptions& options_;
  TrialResult& result_;
  bool hung_ = false, interrupted_ = false;
};

}  // namespace

TrialResult try_predicates(const std::string& path, std::span<const Predicate> predicates,
                           const TrialOptions& options, const Watcher& watcher) {
  TrialResult result;
  for (const Predicate predicate : predicates) {
    PredicateTrial trial(path, predicate, options, result);
    for (const QueryFamily& family : query_families())
      if (!watcher(trial.exercise(family.name, draw(family, predicate, options)))) return result;
    if (!watcher(trial.exercise_fuzz())) return result;
  }
  return result;
}

TrialResult try_query(const std::string& path, const Case& asked, const TrialOptions& options) {
  TrialResult result;
  PredicateTrial(path, asked.predicate, options, result).exercise("query", {asked});
  return result;
}

}  // namespace tribunal::bench
