// Laws of the micro benchmark: what is timed was checked, what is compared was measured side by side.
#include "bench/micro/goals.hpp"
#include "bench/micro/predicate_bench.hpp"
#include "bench/micro/stopwatch.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/plugin/library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <numeric>
#include <set>

namespace tribunal::bench {
namespace {

/// Answers zero always, and keeps how often and for how many queries it was asked.
class ZeroLoop final : public SignLoop {
 public:
  void sign(std::span<Sign> signs) const override {
    std::fill(signs.begin(), signs.end(), Sign::zero);
    asked.push_back(signs.size());
  }
  void decide(std::span<Decision> decisions) const override {
    std::fill(decisions.begin(), decisions.end(), Decision{Sign::zero, Stage::rounded});
  }
  mutable std::vector<std::size_t> asked;
};

Subject zero_subject(const char* name, bool promises_exactness) {
  return {name, promises_exactness,
          [](const QuerySet&) -> SignLoopBinding { return std::make_unique<const ZeroLoop>(); }};
}

PredicateBenchOptions small(std::vector<Subject> subjects, std::initializer_list<const char*> families) {
  PredicateBenchOptions options;
  options.subjects = std::move(subjects);
  options.predicates.assign(all_predicates.begin(), all_predicates.end());
  for (const char* family : families) options.families.push_back(find_query_family(family));
  options.queries = 300;
  options.stopwatch = {.rounds = 3, .milliseconds = 0.01};
  return options;
}

TEST(MicroBench, SubjectsAreTheBackendsInTheirOrder) {
  std::vector<std::string_view> subjects, listed;
  const auto all = backend_subjects();
  for (const Subject& subject : all) subjects.push_back(subject.name);
  for (const BackendEntry& entry : backends()) listed.push_back(entry.about->name);
  EXPECT_EQ(subjects, listed);
}

TEST(MicroBench, DirectLoopsDecideAsTheKernelsDo) {
  const auto subjects = backend_subjects();
  for (const char* family : {"uni", "int14", "near", "degI", "degF", "tiny", "huge"}) {
    const QuerySet queries = draw_query_set(*find_query_family(family), Predicate::incircle, 200, 5);
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      const Kernel2Binding kernel = backends()[s].bind2(queries.planar);
      const SignLoopBinding loop = subjects[s].bind(queries);
      ASSERT_EQ(kernel.index(), loop.index()) << subjects[s].name << ' ' << family;
      if (kernel.index() != 0) continue;
      std::vector<Decision> decisions(queries.count);
      std::vector<Sign> signs(queries.count);
      std::get<0>(loop)->decide(decisions);
      std::get<0>(loop)->sign(signs);
      for (std::size_t i = 0; i < queries.count; ++i) {
        const Point2* p = &queries.planar[4 * i];
        const Decision expected = std::get<0>(kernel)->decide_incircle(p[0], p[1], p[2], p[3]);
        ASSERT_EQ(decisions[i].sign, expected.sign) << subjects[s].name << ' ' << family;
        ASSERT_EQ(decisions[i].stage, expected.stage) << subjects[s].name << ' ' << family;
        ASSERT_EQ(signs[i], expected.sign) << subjects[s].name << ' ' << family;
      }
    }
  }
}

TEST(MicroBench, TheBatchIsTheBackendAskedAtOnce) {
  for (const QueryFamily& family : query_families())
    for (const Predicate predicate : all_predicates) {
      const QuerySet queries = draw_query_set(family, predicate, 333, 9);
      std::vector<Sign> signs(queries.count);
      std::get<0>(batch_subject().bind(queries))->sign(signs);
      EXPECT_EQ(signs, exact_signs(queries)) << family.name << ' ' << to_string(predicate);
    }
}

TEST(MicroBench, CellsComeByPredicateFamilyAndSubject) {
  const auto options = small(backend_subjects(), {"uni", "degF"});
  const auto cells = bench_predicates(options);
  ASSERT_EQ(cells.size(), 4 * 2 * options.subjects.size());
  std::size_t i = 0;
  for (const Predicate predicate : all_predicates)
    for (const char* family : {"uni", "degF"})
      for (const Subject& subject : options.subjects) {
        EXPECT_EQ(cells[i].predicate, predicate);
        EXPECT_EQ(cells[i].family, family);
        EXPECT_EQ(cells[i++].subject, subject.name);
      }
}

TEST(MicroBench, OnlyWhatIsRightHasASpeedAndExactBackendsAreRight) {
  std::set<MicroOutcome> seen;
  for (const MicroCell& cell :
       bench_predicates(small(backend_subjects(), {"uni", "degI", "degF", "mix300"}))) {
    SCOPED_TRACE(cell.subject + ' ' + std::string(to_string(cell.predicate)) + ' ' +
                 std::string(cell.family));
    seen.insert(cell.outcome);
    EXPECT_FALSE(cell.broke_promise);
    const auto decided = std::accumulate(cell.stages.begin(), cell.stages.end(), std::uint64_t{0});
    EXPECT_EQ(decided, cell.queries);
    switch (cell.outcome) {
      case MicroOutcome::timed:
        EXPECT_EQ(cell.wrong, 0U);
        EXPECT_EQ(cell.queries, 300U);
        ASSERT_EQ(cell.nanoseconds.size(), 3U);
        for (const double ns : cell.nanoseconds) EXPECT_GT(ns, 0);
        break;
      case MicroOutcome::wrong_signs:
        EXPECT_GT(cell.wrong_rate(), 0);
        EXPECT_LE(cell.wrong_rate(), 1);
        EXPECT_TRUE(cell.nanoseconds.empty());
        break;
      case MicroOutcome::out_of_domain:
        EXPECT_FALSE(cell.reason.empty());
        EXPECT_EQ(cell.queries, 0U);
        EXPECT_TRUE(cell.nanoseconds.empty());
        break;
      case MicroOutcome::at_fault:
        ADD_FAILURE() << cell.reason;
        break;
    }
  }
  EXPECT_EQ(seen.size(), 3U);
}

TEST(MicroBench, ABrokenPromiseIsToldFromARoughOne) {
  const auto cells =
      bench_predicates(small({zero_subject("liar", true), zero_subject("sloth", false)}, {"uni", "degI"}));
  for (const MicroCell& cell : cells) {
    const bool degenerate = cell.family == "degI";
    EXPECT_EQ(cell.wrong_rate(), degenerate ? 0 : 1);
    EXPECT_EQ(cell.outcome, degenerate ? MicroOutcome::timed : MicroOutcome::wrong_signs);
    EXPECT_EQ(cell.broke_promise, !degenerate && cell.subject == "liar");
  }
}

TEST(Stopwatch, EveryLoopGivesOneValuePerRound) {
  const std::array<ZeroLoop, 3> loops;
  const std::array<const SignLoop*, 3> asked{&loops[0], &loops[1], &loops[2]};
  const auto times = time_side_by_side(asked, 5000, {.rounds = 4, .milliseconds = 0.01});
  ASSERT_EQ(times.size(), 3U);
  for (const auto& values : times) {
    EXPECT_EQ(values.size(), 4U);
    for (const double ns : values) EXPECT_GT(ns, 0);
  }
  for (const ZeroLoop& loop : loops) {
    EXPECT_GE(loop.asked.size(), 5U);  // once to warm up
    for (const std::size_t queries : loop.asked) EXPECT_TRUE(1024 <= queries && queries <= 5000) << queries;
  }
  EXPECT_TRUE(time_side_by_side({}, 5000, {}).empty());
}

TEST(Stopwatch, OneQueryIsEnough) {
  const ZeroLoop loop;
  const std::array<const SignLoop*, 1> asked{&loop};
  EXPECT_EQ(time_side_by_side(asked, 1, {.rounds = 1, .milliseconds = 0.01}).at(0).size(), 1U);
}

MicroCell timed_cell(std::string subject, std::vector<double> nanoseconds) {
  MicroCell cell;
  cell.subject = std::move(subject);
  cell.predicate = Predicate::incircle;
  cell.family = "uni";
  cell.outcome = MicroOutcome::timed;
  cell.nanoseconds = std::move(nanoseconds);
  return cell;
}

TEST(Goals, RatiosArePairedByRound) {
  const std::vector<Goal> goals{{"fast", "slow", "uni", Predicate::incircle, 0.5}};
  // The clock slows down fourfold from round to round; the ratio does not.
  const std::vector<MicroCell> cells{timed_cell("fast", {1, 4, 16}), timed_cell("slow", {2, 8, 32})};
  const auto measured = measure_goals(goals, cells);
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_EQ(measured[0].ratio, 0.5);
  EXPECT_EQ(measured[0].interval.low, 0.5);
  EXPECT_EQ(measured[0].interval.high, 0.5);
  EXPECT_TRUE(measured[0].met());
}

TEST(Goals, AMissIsAMiss) {
  const std::vector<Goal> goals{{"fast", "slow", "uni", Predicate::incircle, 0.49}};
  const std::vector<MicroCell> cells{timed_cell("fast", {1, 1, 1}), timed_cell("slow", {2, 2, 2})};
  EXPECT_FALSE(measure_goals(goals, cells).at(0).met());
}

TEST(Goals, WithoutATimeThereIsAReasonAndUnaskedGoalsAreLeftOut) {
  const std::vector<Goal> goals{{"fast", "slow", "uni", Predicate::incircle, 0.5},
                                {"fast", "slow", "near", Predicate::incircle, 0.5}};
  std::vector<MicroCell> cells{timed_cell("fast", {1})};
  EXPECT_EQ(measure_goals(goals, cells).size(), 1U);
  EXPECT_EQ(measure_goals(goals, cells)[0].reason, "slow was not asked");
  cells.push_back(timed_cell("slow", {}));
  cells[1].outcome = MicroOutcome::wrong_signs;
  cells[1].wrong = 1;
  EXPECT_EQ(measure_goals(goals, cells)[0].reason, "slow gives wrong signs");
  EXPECT_FALSE(measure_goals(goals, cells)[0].met());
}

TEST(Goals, NameBackendsFamiliesAndPeersThatExist) {
  std::set<std::string> subjects{"cgal-epick", "filtered-batch"};
  for (const BackendEntry& entry : backends()) subjects.insert(std::string(entry.about->name));
  EXPECT_EQ(goals().size(), 28U);
  for (const Goal& goal : goals()) {
    EXPECT_TRUE(subjects.count(std::string(goal.subject))) << goal.subject;
    EXPECT_TRUE(subjects.count(std::string(goal.rival))) << goal.rival;
    EXPECT_NE(find_query_family(goal.family), nullptr) << goal.family;
    EXPECT_TRUE(0 < goal.at_most && goal.at_most < 2) << goal.at_most;
  }
}

TEST(Peers, AreCheckedLikeEverybodyElse) {
  const Subject peer = plugin_subject(TRIBUNAL_SAMPLE_PEER).value();
  EXPECT_EQ(peer.name, "optimist");
  const auto cells = bench_predicates(small({peer}, {"uni", "int14"}));
  ASSERT_EQ(cells.size(), 8U);
  EXPECT_EQ(cells[0].outcome, MicroOutcome::wrong_signs);
  EXPECT_NEAR(cells[0].wrong_rate(), 0.5, 0.1);
  EXPECT_FALSE(cells[0].broke_promise);
  EXPECT_EQ(cells[1].reason, "refused by the plug-in");
  for (std::size_t i = 2; i < cells.size(); ++i)
    EXPECT_EQ(cells[i].reason, "it offers no batch of this predicate");
}

/// Right in its first calls, then behind a changed rounding mode.
class TurningLoop final : public SignLoop {
 public:
  explicit TurningLoop(const QuerySet& queries) : truth_(exact_signs(queries)) {}
  void sign(std::span<Sign> signs) const override {
    std::copy_n(truth_.begin(), signs.size(), signs.begin());
    std::fesetround(FE_UPWARD);
  }
  void decide(std::span<Decision> decisions) const override {
    for (std::size_t i = 0; i < decisions.size(); ++i) decisions[i] = {truth_[i], Stage::plugin};
  }

 private:
  std::vector<Sign> truth_;
};

TEST(Peers, OneThatChangesRoundingHasNoSpeedAndHarmsNobody) {
  const Subject turning{"turning", false, [](const QuerySet& queries) -> SignLoopBinding {
                          return std::make_unique<const TurningLoop>(queries);
                        }};
  const Subject flushing = zero_subject("flushing", false);
  auto subjects = backend_subjects();
  std::erase_if(subjects, [](const Subject& subject) { return subject.name != "gmp"; });
  subjects.insert(subjects.begin(), {turning, flushing});
  auto options = small(subjects, {"uni", "near"});
  options.faults["flushing"] = "subnormal numbers are flushed to zero after it was loaded";
  const auto cells = bench_predicates(options);
  ASSERT_EQ(cells.size(), 24U);
  for (const MicroCell& cell : cells) {
    const bool is_ours = cell.subject == "gmp";
    EXPECT_EQ(cell.outcome, is_ours ? MicroOutcome::timed : MicroOutcome::at_fault) << cell.subject;
    EXPECT_EQ(cell.broke_promise, !is_ours);
    EXPECT_EQ(cell.nanoseconds.empty(), !is_ours);
    if (cell.subject == "turning") {
      EXPECT_EQ(cell.reason, "the rounding mode is not to nearest while it was timed");
    }
  }
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(MicroBench, AnInterruptLeavesWholeFamilies) {
  auto options = small({zero_subject("zero", false)}, {"uni", "near", "degI"});
  options.interrupted = [] { return true; };
  EXPECT_EQ(bench_predicates(options).size(), 1U);
}

TEST(Peers, WhatIsNoModuleIsRefused) {
  EXPECT_THROW(plugin_subject("/nonexistent/module.so"), PluginError);
  EXPECT_FALSE(plugin_subject(TRIBUNAL_NO_PEER));
}

}  // namespace
}  // namespace tribunal::bench
