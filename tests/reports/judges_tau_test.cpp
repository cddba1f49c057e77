// Judges of tau: right on honest rows, and a planted lie is refuted.
#include "datasets/random.hpp"
#include "reports/judges/bounds.hpp"
#include "tests/reports/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tribunal::reports {
namespace {

/// `count` runs at n whose tau is about `mean`, spread evenly over mean -+ spread.
std::vector<bench::Row> tau_rows(std::uint64_t n, int count, double mean, double spread) {
  std::vector<bench::Row> rows;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 0 : 2.0 * i / (count - 1) - 1;
    rows.push_back(
        run_row("green-sibson", n, static_cast<std::uint64_t>(i + 1), {{"tau", mean + spread * share}}));
  }
  return rows;
}

const nlohmann::json bound_rule = {{"bound", "tau"}, {"headline", 1000}};

TEST(Bounds, of_eq_3_3_0_match_figures_worked_out_elsewhere) {
  const Bound* bound = find_bound("tau");
  EXPECT_NEAR(bound->at(3), 1, 1e-12);  // equality: one triangle
  EXPECT_NEAR(bound->at(10), 26.565, 5e-4);
  EXPECT_NEAR(bound->at(1000), 5898.218, 5e-4);
  EXPECT_NEAR(bound->at(100000), 599829.148, 5e-4);
  EXPECT_NEAR(find_bound("tau-with-ghosts")->at(1000), 5934.1, 0.05);
  EXPECT_EQ(find_bound("created")->at(1000), 9000);
  EXPECT_EQ(find_bound("no such"), nullptr);
}

TEST(MeanBelowBound, reproduces_a_mean_below) {
  const Judgement judgement = try_rule("mean-below-bound", bound_rule, tau_rows(1000, 200, 5768.7, 80));
  EXPECT_EQ(judgement.verdict, Verdict::reproduced);
  EXPECT_NEAR(*judgement.measured, 5768.7, 1e-6);
  EXPECT_NEAR(*judgement.bound, 5898.218, 1e-3);
  EXPECT_LT(judgement.interval->low, 5768.7);
  EXPECT_GT(judgement.interval->high, 5768.7);
}

TEST(MeanBelowBound, refutes_a_mean_above) {
  EXPECT_EQ(try_rule("mean-below-bound", bound_rule, tau_rows(1000, 200, 6000, 80)).verdict,
            Verdict::refuted);
}

TEST(MeanBelowBound, single_runs_above_do_not_refute) {
  auto rows = tau_rows(1000, 200, 5768.7, 80);
  rows[0].counters["tau"] = 5917;
  EXPECT_EQ(try_rule("mean-below-bound", bound_rule, rows).verdict, Verdict::reproduced);
}

TEST(MeanBelowBound, one_bad_size_among_good_ones_refutes) {
  auto rows = tau_rows(1000, 200, 5768.7, 80);
  const auto bad = tau_rows(100, 50, 560, 20);
  rows.insert(rows.end(), bad.begin(), bad.end());
  const Judgement judgement = try_rule("mean-below-bound", bound_rule, rows);
  EXPECT_EQ(judgement.verdict, Verdict::refuted);
  EXPECT_NEAR(*judgement.measured, 560, 1e-9);  // the size that fails is the one shown
}

TEST(MeanBelowBound, an_interval_across_the_bound_decides_nothing_and_says_what_it_could_see) {
  const Judgement judgement = try_rule("mean-below-bound", bound_rule, tau_rows(1000, 30, 5898, 400));
  EXPECT_EQ(judgement.verdict, Verdict::inconclusive);
  EXPECT_NE(judgement.lines.back().find("Power"), std::string::npos);
}

TEST(MeanBelowBound, few_runs_failed_runs_and_missing_counters_carry_no_verdict) {
  EXPECT_EQ(try_rule("mean-below-bound", bound_rule, tau_rows(1000, 19, 5768, 80)).verdict,
            Verdict::inconclusive);
  auto rows = tau_rows(1000, 200, 5768, 80);
  rows[3].outcome = "loop";
  EXPECT_EQ(try_rule("mean-below-bound", bound_rule, rows).verdict, Verdict::inconclusive);
  rows = tau_rows(1000, 200, 5768, 80);
  rows[3].counters.clear();
  EXPECT_EQ(try_rule("mean-below-bound", bound_rule, rows).verdict, Verdict::inconclusive);
}

TEST(MeanAtValue, reproduces_refutes_and_abstains) {
  const nlohmann::json rule = {{"value", "tau-uniform"}, {"tolerance", 0.0015}};
  const double value = find_bound("tau-uniform")->at(1000);
  EXPECT_NEAR(value, 5769, 2);
  EXPECT_EQ(try_rule("mean-at-value", rule, tau_rows(1000, 500, value, 60)).verdict, Verdict::reproduced);
  EXPECT_EQ(try_rule("mean-at-value", rule, tau_rows(1000, 500, value + 40, 60)).verdict, Verdict::refuted);
  EXPECT_EQ(try_rule("mean-at-value", rule, tau_rows(1000, 500, value - 40, 60)).verdict, Verdict::refuted);
  EXPECT_EQ(try_rule("mean-at-value", rule, tau_rows(1000, 20, value, 200)).verdict, Verdict::inconclusive);
}

bench::Row orders_row(std::uint64_t n, double orders, double exceeding) {
  bench::Row row = run_row("tau-over-orders", n, 1,
                           {{"orders", orders},
                            {"exceeding", exceeding},
                            {"tau_bound", find_bound("tau")->at(n)},
                            {"tau_max", 5920},
                            {"tau_mean", 5768},
                            {"tau_sd", 46}});
  row.cell.parameters = {{"algorithm", "green-sibson"}, {"orders", "4000"}};
  return row;
}

TEST(SingleRuns, one_run_above_refutes) {
  const Judgement judgement = try_rule("single-runs-below-bound", {}, {orders_row(1000, 4000, 1)});
  EXPECT_EQ(judgement.verdict, Verdict::refuted);
  EXPECT_DOUBLE_EQ(*judgement.measured, 1 / 4000.0);
  EXPECT_EQ(try_rule("single-runs-below-bound", {}, tau_rows(1000, 50, 5890, 30)).verdict, Verdict::refuted);
}

TEST(SingleRuns, no_number_of_obedient_runs_proves_it) {
  const Judgement judgement = try_rule("single-runs-below-bound", {}, {orders_row(1000, 4000, 0)});
  EXPECT_EQ(judgement.verdict, Verdict::inconclusive);
  EXPECT_NE(judgement.lines.back().find("0.0749 %"), std::string::npos);  // 1 - 0.05^(1/4000)
}

TEST(SingleRuns, an_experiment_that_counted_against_another_bound_is_not_believed) {
  bench::Row row = orders_row(1000, 4000, 7);
  row.counters["tau_bound"] = 5000;
  EXPECT_EQ(try_rule("single-runs-below-bound", {}, {row}).verdict, Verdict::inconclusive);
}

/// Scopes of 6 points in convex position would be other numbers; these satisfy the identities with T_0 = 7.
std::vector<bench::Row> six_points(double mean) {
  bench::Row scopes = run_row("scopes", 6, 1, {{"T.0", 7}, {"T.1", 7}, {"T.2", 5}, {"T.3", 1}});
  scopes.counters["tau_expected"] = 7.0 + 7.0 / 4 + 5.0 / 10 + 1.0 / 20;
  bench::Row orders =
      run_row("tau-over-orders", 6, 1, {{"orders", 10000}, {"tau_mean", mean}, {"tau_sd", 1}});
  orders.cell.parameters = {{"algorithm", "green-sibson"}};
  return {scopes, orders};
}

TEST(ExpectedTau, agrees_within_four_standard_errors) {
  const Judgement judgement = try_rule("expected-tau", {}, six_points(9.3 + 0.03));
  EXPECT_EQ(judgement.verdict, Verdict::reproduced);
  EXPECT_NEAR(*judgement.measured, 3, 1e-6);
  EXPECT_EQ(try_rule("expected-tau", {}, six_points(9.3 + 0.05)).verdict, Verdict::refuted);
  EXPECT_EQ(try_rule("expected-tau", {}, six_points(9.3 - 0.05)).verdict, Verdict::refuted);
}

TEST(ExpectedTau, does_not_take_the_experiments_own_sum_on_trust) {
  auto rows = six_points(9.3);
  rows[0].counters["tau_expected"] = 9.4;
  EXPECT_EQ(try_rule("expected-tau", {}, rows).verdict, Verdict::inconclusive);
  rows = six_points(9.3);
  rows.pop_back();
  EXPECT_EQ(try_rule("expected-tau", {}, rows).verdict, Verdict::inconclusive);
}

TEST(ScopeIdentities, hold_and_a_single_wrong_number_refutes) {
  // T_j + T_{3-j} = 2(j+1)(4-j): 8, 12; T_j <= (j+1)(12 - 5j/2 - 5) for j+1 <= 2: 7, 9; sum C(6,3) = 20.
  auto rows = six_points(9.3);
  EXPECT_EQ(try_rule("scope-identities", {}, rows).verdict, Verdict::reproduced);
  rows[0].counters["T.1"] = 8;
  EXPECT_EQ(try_rule("scope-identities", {}, rows).verdict, Verdict::refuted);
  rows[0].counters["T.1"] = 7;
  rows[0].counters["T.0"] = 8;  // keeps nothing
  rows[0].counters["T.3"] = 0;  // keeps the sum and the pair, breaks the upper bound
  EXPECT_EQ(try_rule("scope-identities", {}, rows).verdict, Verdict::refuted);
}

}  // namespace
}  // namespace tribunal::reports
