// Judges of exact statements about runs: one violation anywhere refutes.
#include "tests/reports/rows.hpp"

#include <gtest/gtest.h>

namespace tribunal::reports {
namespace {

/// The counters of an honest Green-Sibson run: N sites, E on edges, F flips, some outside the hull.
bench::Row honest_run(const std::string& task, std::uint64_t points, double duplicates, double on_edge,
                      double flips) {
  const double n = static_cast<double>(points) - duplicates;
  const double created = 4 + 3 * (n - 3) + on_edge + 2 * flips;
  const double with_ghosts = 3 * (n - 2) + on_edge + flips;
  const bool green_sibson = task == "green-sibson";
  bench::Row row = run_row(task, points, 1,
                           {{"points", static_cast<double>(points)},
                            {"duplicates", duplicates},
                            {"dimension", 2},
                            {"hull", 7},
                            {"triangles", 2 * n - 9},
                            {"outside_hull", 12},
                            {"tau_with_ghosts", with_ghosts},
                            {"tau", with_ghosts - 24},
                            {"created", green_sibson ? created : with_ghosts},
                            {"conflict_tests", green_sibson ? created - 4 : 5000},
                            {"on_edge", on_edge},
                            {"flips", green_sibson ? flips : 0},
                            {"ties", 0}});
  if (green_sibson) row.counters["history.nodes"] = created;
  row.digest = "same";
  return row;
}

TEST(RunIdentities, hold_with_duplicates_and_sites_on_edges) {
  const std::vector rows{honest_run("green-sibson", 100, 5, 3, 250), honest_run("bowyer", 100, 5, 3, 250)};
  const Judgement judgement = try_rule("run-identities", {}, rows);
  EXPECT_EQ(judgement.verdict, Verdict::reproduced);
  EXPECT_EQ(*judgement.measured, 0);
}

/// Law: each counter that an identity mentions is held to it.
class RunIdentityLies : public testing::TestWithParam<const char*> {};

TEST_P(RunIdentityLies, one_count_too_many_is_found) {
  std::vector rows(20, honest_run("green-sibson", 100, 0, 0, 250));
  rows[13].counters[GetParam()] += 1;
  const Judgement judgement = try_rule("run-identities", {}, rows);
  EXPECT_EQ(judgement.verdict, Verdict::refuted);
  EXPECT_GE(*judgement.measured, 1);
  EXPECT_NE(judgement.lines.back().find("First:"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Counters, RunIdentityLies,
                         testing::Values("tau", "tau_with_ghosts", "created", "flips", "on_edge",
                                         "outside_hull", "conflict_tests", "history.nodes", "triangles",
                                         "hull", "duplicates"));

TEST(RunIdentities, runs_without_triangles_are_left_out_and_alone_decide_nothing) {
  bench::Row flat = honest_run("green-sibson", 50, 0, 0, 0);
  flat.counters["dimension"] = 1;
  flat.counters["tau"] = 99;
  EXPECT_EQ(try_rule("run-identities", {}, {flat, honest_run("green-sibson", 100, 0, 0, 9)}).verdict,
            Verdict::reproduced);
  EXPECT_EQ(try_rule("run-identities", {}, {flat}).verdict, Verdict::inconclusive);
}

TEST(OrderDeterminesTau, agreement_disagreement_and_ties) {
  std::vector rows{honest_run("green-sibson", 100, 0, 0, 250), honest_run("bowyer", 100, 0, 0, 250),
                   honest_run("watson", 100, 0, 0, 250)};
  EXPECT_EQ(try_rule("order-determines-tau", {}, rows).verdict, Verdict::reproduced);
  rows[2].counters["tau"] += 1;
  EXPECT_EQ(try_rule("order-determines-tau", {}, rows).verdict, Verdict::refuted);
  rows[2].counters["tau"] -= 1;
  rows[2].digest = "another mesh";
  EXPECT_EQ(try_rule("order-determines-tau", {}, rows).verdict, Verdict::refuted);
  rows[2].counters["ties"] = 1;
  EXPECT_EQ(try_rule("order-determines-tau", {}, rows).verdict, Verdict::reproduced);
  rows[1].counters["ties"] = 1;
  EXPECT_EQ(try_rule("order-determines-tau", {}, rows).verdict, Verdict::inconclusive);
}

TEST(OrderDeterminesTau, other_inputs_are_not_compared) {
  std::vector rows{honest_run("green-sibson", 100, 0, 0, 250), honest_run("bowyer", 100, 0, 0, 250)};
  rows[1].counters["tau"] += 1;
  rows[1].cell.order_seed = 2;
  EXPECT_EQ(try_rule("order-determines-tau", {}, rows).verdict, Verdict::inconclusive);
}

bench::Row outcome_row(const std::string& backend, const std::string& outcome) {
  bench::Row row = run_row("bowyer", 200, 1, {});
  row.cell.backend = backend;
  row.outcome = outcome;
  return row;
}

TEST(FailureRates, counts_failures_apart_from_refusals) {
  const nlohmann::json rule = {{"suspects", nlohmann::json::array({"double"})},
                               {"exact", nlohmann::json::array({"gmp"})}};
  std::vector rows{outcome_row("double", "ok"),    outcome_row("double", "loop"),
                   outcome_row("double", "crash"), outcome_row("double", "out_of_domain"),
                   outcome_row("gmp", "ok"),       outcome_row("gmp", "refused_input")};
  const Judgement judgement = try_rule("failure-rates", rule, rows);
  EXPECT_EQ(judgement.verdict, Verdict::reproduced);
  EXPECT_DOUBLE_EQ(*judgement.measured, 2.0 / 3);
  EXPECT_GT(judgement.interval->low, 0);

  rows.push_back(outcome_row("gmp", "timeout"));
  EXPECT_EQ(try_rule("failure-rates", rule, rows).verdict, Verdict::inconclusive);
  rows.push_back(outcome_row("gmp", "non_delaunay"));
  EXPECT_EQ(try_rule("failure-rates", rule, rows).verdict, Verdict::refuted);
}

TEST(FailureRates, without_a_failure_of_the_suspect_nothing_is_shown) {
  const nlohmann::json rule = {{"suspects", nlohmann::json::array({"double"})},
                               {"exact", nlohmann::json::array({"gmp"})}};
  EXPECT_EQ(try_rule("failure-rates", rule, {outcome_row("double", "ok"), outcome_row("gmp", "ok")}).verdict,
            Verdict::inconclusive);
  EXPECT_EQ(try_rule("failure-rates", rule, {outcome_row("double", "loop")}).verdict, Verdict::inconclusive);
}

}  // namespace
}  // namespace tribunal::reports
