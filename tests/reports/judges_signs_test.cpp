// Judges of predicates.
#include "tests/reports/rows.hpp"

#include <gtest/gtest.h>

namespace tribunal::reports {
namespace {

bench::Row differential(const std::string& backend, double queries, double wrong) {
  bench::Row row = run_row("sign-differential", 1000, 1, {{"queries", queries}, {"wrong", wrong}});
  row.cell.backend = backend;
  return row;
}

TEST(ExactSigns, only_the_named_backends_are_judged) {
  const nlohmann::json rule = {{"exact", nlohmann::json::array({"gmp", "filtered"})}};
  std::vector rows{differential("double", 1000, 300), differential("gmp", 1000, 0),
                   differential("filtered", 1000, 0)};
  EXPECT_EQ(try_rule("exact-signs", rule, rows).verdict, Verdict::reproduced);
  rows.push_back(differential("filtered", 100000, 1));
  EXPECT_EQ(try_rule("exact-signs", rule, rows).verdict, Verdict::refuted);
  EXPECT_EQ(try_rule("exact-signs", rule, {differential("gmp", 1000, 0)}).verdict, Verdict::inconclusive);
}

bench::Row printed(double second_sign, double wrong_corrected) {
  bench::Row row = run_row("knuth-printed", 1000, 1,
                           {{"witness.1.exact", 0},
                            {"witness.1.printed", -1},
                            {"witness.1.corrected", 0},
                            {"witness.2.exact", 1},
                            {"witness.2.printed", second_sign},
                            {"witness.2.corrected", 1},
                            {"queries", 1000},
                            {"wrong.printed", 188},
                            {"wrong.corrected", wrong_corrected}});
  row.cell.parameters = {{"generator", "uniform"}};
  return row;
}

TEST(Witnesses, an_erring_witness_refutes) {
  const Judgement judgement = try_rule("witnesses", {}, {printed(-1, 0)});
  EXPECT_EQ(judgement.verdict, Verdict::refuted);
  EXPECT_DOUBLE_EQ(*judgement.measured, 0.188);
}

TEST(Witnesses, code_that_never_errs_is_reproduced) {
  bench::Row row = printed(1, 0);
  row.counters["witness.1.printed"] = 0;
  row.counters["wrong.printed"] = 0;
  EXPECT_EQ(try_rule("witnesses", {}, {row}).verdict, Verdict::reproduced);
  row.counters["wrong.printed"] = 1;  // no witness, but a random case
  EXPECT_EQ(try_rule("witnesses", {}, {row}).verdict, Verdict::refuted);
}

TEST(Witnesses, a_transcription_whose_corrected_form_errs_is_not_believed) {
  EXPECT_EQ(try_rule("witnesses", {}, {printed(-1, 1)}).verdict, Verdict::inconclusive);
  bench::Row row = printed(-1, 0);
  row.counters["witness.1.corrected"] = 1;
  EXPECT_EQ(try_rule("witnesses", {}, {row}).verdict, Verdict::inconclusive);
}

bench::Row map_row(double false_zero) {
  bench::Row row =
      run_row("sign-map", 0, 1,
              {{"pixels", 65536}, {"false_zero", false_zero}, {"inverted", 672}, {"false_nonzero", 0}});
  row.cell.backend = "double";
  row.cell.parameters = {{"figure", "2a"}};
  return row;
}

TEST(SignMapCounts, equality_is_exact) {
  nlohmann::json entry = {{"backend", "double"},
                          {"figure", "2a"},
                          {"false_zero", 11300},
                          {"inverted", 672},
                          {"false_nonzero", 0}};
  nlohmann::json rule;
  rule["expected"] = nlohmann::json::array();
  rule["expected"].push_back(entry);
  EXPECT_EQ(try_rule("sign-map-counts", rule, {map_row(11300)}).verdict, Verdict::reproduced);
  EXPECT_EQ(try_rule("sign-map-counts", rule, {map_row(11301)}).verdict, Verdict::refuted);
  rule["expected"][0]["figure"] = "2b";
  EXPECT_EQ(try_rule("sign-map-counts", rule, {map_row(11300)}).verdict, Verdict::inconclusive);
}

bench::Row counted(const std::string& backend, int bits, std::map<std::string, double> counters) {
  bench::Row row = run_row("counting", 10, 1, std::move(counters));
  row.cell.backend = backend;
  row.cell.bits = bits;
  row.cell.parameters = {{"kind", "even"}};
  return row;
}

TEST(Counters, every_relation_must_hold) {
  const std::vector rows{counted("a", 8, {{"wrong", 2}, {"queries", 10}}),
                         counted("b", 8, {{"wrong", 0}, {"queries", 10}})};
  const auto verdict = [&](nlohmann::json hold) {
    return try_rule("counters", {{"hold", {std::move(hold)}}}, rows).verdict;
  };
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"equals", 2}}), Verdict::reproduced);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"equals", 1}}), Verdict::refuted);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"least", 2}}), Verdict::reproduced);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"least", 2.5}}), Verdict::refuted);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"most", 2}}), Verdict::reproduced);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"most", 1.5}}), Verdict::refuted);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"per", "queries"}, {"equals", 0.1}}), Verdict::reproduced);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"least", 1}, {"most", 1}}), Verdict::refuted);
}

TEST(Counters, each_speaks_of_every_row) {
  const std::vector rows{counted("a", 8, {{"wide", 6}, {"runs", 1}}),
                         counted("b", 8, {{"wide", 4}, {"runs", 1}})};
  const auto verdict = [&](nlohmann::json hold, bool each) {
    hold.update({{"counter", "wide"}, {"per", "runs"}, {"each", each}});
    return try_rule("counters", {{"hold", {std::move(hold)}}}, rows).verdict;
  };
  for (const nlohmann::json& hold : {nlohmann::json{{"most", 5}}, {{"least", 5}}, {{"equals", 5}}}) {
    EXPECT_EQ(verdict(hold, false), Verdict::reproduced) << hold;
    EXPECT_EQ(verdict(hold, true), Verdict::refuted) << hold;
  }
  EXPECT_EQ(verdict({{"least", 4}, {"most", 6}}, true), Verdict::reproduced);
}

TEST(Counters, what_rests_on_chance_says_how_often_it_errs) {
  const std::vector rows{counted("a", 8, {{"deviation", 4}})};
  nlohmann::json rule{{"hold", {{{"counter", "deviation"}, {"most", 5}}}}};
  EXPECT_EQ(try_rule("counters", rule, rows).false_refutation, 0);
  rule["false_refutation"] = 3e-5;
  EXPECT_EQ(try_rule("counters", rule, rows).false_refutation, 3e-5);
}

TEST(Counters, selectors_choose_the_rows_that_are_summed) {
  const std::vector rows{counted("a", 8, {{"wrong", 2}}), counted("a", 9, {{"wrong", 3}}),
                         counted("b", 8, {{"wrong", 5}})};
  const auto equals = [&](nlohmann::json selected, double sum) {
    selected.update({{"counter", "wrong"}, {"equals", sum}});
    return try_rule("counters", {{"hold", {std::move(selected)}}}, rows).verdict == Verdict::reproduced;
  };
  EXPECT_TRUE(equals({{"backend", "a"}}, 5));
  EXPECT_TRUE(equals({{"bits", 8}}, 7));
  EXPECT_TRUE(equals({{"backend", "a"}, {"bits", 9}}, 3));
  EXPECT_TRUE(equals({{"kind", "even"}, {"task", "counting"}}, 10));
  EXPECT_FALSE(equals({{"backend", "a"}}, 10));
}

/// A relation about nothing holds for nothing: a misspelt selector must not make a claim come out.
TEST(Counters, no_matching_rows_are_no_verdict) {
  const std::vector rows{counted("a", 8, {{"wrong", 0}})};
  const auto verdict = [&](nlohmann::json entry) {
    return try_rule("counters", {{"hold", {std::move(entry)}}}, rows).verdict;
  };
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"backend", "c"}, {"equals", 0}}), Verdict::inconclusive);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"kin", "even"}, {"equals", 0}}), Verdict::inconclusive);
  EXPECT_EQ(verdict({{"counter", "wrong"}, {"per", "queries"}, {"equals", 0}}), Verdict::inconclusive);
  EXPECT_EQ(verdict({{"counter", "wrong"}}), Verdict::inconclusive);
}

}  // namespace
}  // namespace tribunal::reports
