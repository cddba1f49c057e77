// The judge of growth: it finds the law the counts were made from, and no other.
#include "datasets/random.hpp"
#include "tests/reports/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tribunal::reports {
namespace {

using Law = std::function<double(double)>;

/// Counts that follow `law` up to noise of relative size 1/sqrt(N), five seeds per size.
std::vector<bench::Row> grown(const Law& law, const std::string& counter, std::uint64_t sizes = 9) {
  Random random(3);
  std::vector<bench::Row> rows;
  std::uint64_t n = 200;
  for (std::uint64_t k = 0; k < sizes; ++k, n *= 2)
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto size = static_cast<double>(n);
      const double noise = 1 + (random.unit() - 0.5) / std::sqrt(size);
      rows.push_back(run_row("green-sibson", n, seed, {{counter, noise * law(size)}, {"zero", 0}}));
    }
  return rows;
}

nlohmann::json rule(const std::string& law, const std::string& counter, const std::string& shape = "total") {
  return {{"law", law}, {"counters", nlohmann::json::array({counter})}, {"shape", shape}};
}

double n_log_n(double n) { return 4 * n * std::log(n) + 9 * n; }

TEST(GrowthModel, reproduces_the_true_law) {
  const Judgement judgement = try_rule("growth-model", rule("N log N", "tests"), grown(n_log_n, "tests"));
  EXPECT_EQ(judgement.verdict, Verdict::reproduced);
  EXPECT_GE(*judgement.measured, 6);
  EXPECT_EQ(judgement.figures.size(), 2U);
}

TEST(GrowthModel, refutes_a_planted_rival) {
  const auto rows = grown([](double n) { return 0.5 * std::pow(n, 4.0 / 3) + 9 * n; }, "tests");
  EXPECT_EQ(try_rule("growth-model", rule("N log N", "tests"), rows).verdict, Verdict::refuted);
  EXPECT_EQ(try_rule("growth-model", rule("N^4/3", "tests"), rows).verdict, Verdict::reproduced);
  EXPECT_EQ(try_rule("growth-model", rule("N^2", "tests"), grown(n_log_n, "tests")).verdict,
            Verdict::refuted);
}

TEST(GrowthModel, depths_have_laws_of_their_own) {
  const auto logarithmic = grown([](double n) { return 4 * std::log(n) - 7; }, "depth");
  EXPECT_EQ(try_rule("growth-model", rule("log N", "depth", "depth"), logarithmic).verdict,
            Verdict::reproduced);
  const auto linear = grown([](double n) { return 0.9 * n; }, "depth");
  EXPECT_EQ(try_rule("growth-model", rule("log N", "depth", "depth"), linear).verdict, Verdict::refuted);
}

TEST(GrowthModel, too_few_sizes_unknown_laws_and_counts_of_zero_carry_no_verdict) {
  EXPECT_EQ(try_rule("growth-model", rule("N log N", "tests"), grown(n_log_n, "tests", 5)).verdict,
            Verdict::inconclusive);
  EXPECT_EQ(try_rule("growth-model", rule("N^7", "tests"), grown(n_log_n, "tests")).verdict,
            Verdict::inconclusive);
  EXPECT_EQ(try_rule("growth-model", rule("N log N", "zero"), grown(n_log_n, "tests")).verdict,
            Verdict::inconclusive);
}

TEST(GrowthModel, times_are_shown_and_change_nothing) {
  auto rows = grown(n_log_n, "tests");
  bench::Row timed = run_row("green-sibson", 200, 1, {{"tests", 1e12}});
  timed.cell.measure = bench::Measure::time;
  timed.seconds = {0.001, 0.002, 0.003};
  rows.push_back(timed);
  const Judgement judgement = try_rule("growth-model", rule("N log N", "tests"), rows);
  EXPECT_EQ(judgement.verdict, Verdict::reproduced);
  EXPECT_EQ(judgement.figures.size(), 3U);
  EXPECT_NE(judgement.lines.back().find("10000 at N = 200"), std::string::npos);  // nanoseconds per site
}

}  // namespace
}  // namespace tribunal::reports
