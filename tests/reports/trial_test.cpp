// From rows to verdicts, as documents and as text.
#include "tests/reports/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tribunal::reports {
namespace {

std::vector<Tried> three_trials() {
  Tried good{claim_of("scope-identities"), {}, "tribunal claims test"};
  good.claim.id = "T4";
  good.judgement.verdict = Verdict::reproduced;
  good.judgement.measured = 5768.7;
  good.judgement.interval = {5758.1, 5779.3};
  good.judgement.bound = 5898.2;
  good.judgement.p_value = 0.01;
  good.judgement.false_refutation = 0.001;
  Tried surprise = good;
  surprise.claim.id = "surprising";
  surprise.judgement = {};
  surprise.judgement.verdict = Verdict::refuted;
  surprise.judgement.p_value = 0.02;
  Tried absent{claim_of("scope-identities"), try_claim(claim_of("scope-identities"), {}), "x"};
  return {good, surprise, absent};
}

TEST(Trials, no_rows_are_untried_and_untried_surprises_nobody) {
  const auto trials = three_trials();
  EXPECT_EQ(trials[2].judgement.verdict, Verdict::untried);
  EXPECT_TRUE(trials[0].as_expected());
  EXPECT_FALSE(trials[1].as_expected());
  EXPECT_TRUE(trials[2].as_expected());
}

TEST(Trials, inconclusive_is_not_as_expected) {
  Tried tried{claim_of("scope-identities"), {}, ""};
  tried.judgement.verdict = Verdict::inconclusive;
  EXPECT_FALSE(tried.as_expected());
}

TEST(Trials, json_has_the_promised_shape) {
  const nlohmann::json json = claims_json(three_trials());
  const nlohmann::json& first = json.at("claims").at(0);
  EXPECT_EQ(first.at("id"), "T4");
  EXPECT_EQ(first.at("verdict"), "reproduced");
  EXPECT_EQ(first.at("expected"), "reproduced");
  EXPECT_EQ(first.at("source"), "nobody");
  EXPECT_EQ(first.at("measured"), 5768.7);
  EXPECT_EQ(first.at("interval"), nlohmann::json::array({5758.1, 5779.3}));
  EXPECT_EQ(first.at("bound"), 5898.2);
  EXPECT_EQ(first.at("command"), "tribunal claims test");
  EXPECT_TRUE(json.at("claims").at(2).at("measured").is_null());
  EXPECT_TRUE(json.at("claims").at(2).at("interval").is_null());
}

TEST(Trials, the_family_is_adjusted_together) {
  const Family all = family(three_trials());
  EXPECT_DOUBLE_EQ(all.adjusted[0], 0.02);
  EXPECT_DOUBLE_EQ(all.adjusted[1], 0.02);
  EXPECT_TRUE(std::isnan(all.adjusted[2]));
  EXPECT_DOUBLE_EQ(all.expected_false_refutations, 0.001);
}

TEST(VerdictTable, marks_surprises_and_sums_up) {
  const std::string table = verdict_table(three_trials());
  EXPECT_NE(table.find("5768.7"), std::string::npos);
  EXPECT_NE(table.find("refuted (!)"), std::string::npos);
  EXPECT_NE(table.find("3 claims: 1 reproduced, 1 refuted, 1 untried; 1 not as expected"), std::string::npos);
  EXPECT_NE(verdict_table({}).find("0 claims"), std::string::npos);
}

TEST(VerdictTable, names_untried_claims_in_one_line) {
  std::vector<Tried> trials = three_trials();
  trials[2].claim.title = "About nothing";
  const std::string table = verdict_table(trials);
  EXPECT_NE(table.find("\nuntried: " + trials[2].claim.id + "\n"), std::string::npos) << table;
  EXPECT_EQ(table.find(trials[2].claim.title), std::string::npos) << table;
  EXPECT_EQ(verdict_table(std::span(trials).subspan(2)), "1 claim: 1 untried.\n");
}

}  // namespace
}  // namespace tribunal::reports
