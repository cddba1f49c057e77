// Statistics against values computed once with SciPy 1.10.1; the call stands beside each.
#include "bench/statistics.hpp"

#include "datasets/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tribunal::bench {
namespace {

TEST(Normal, cdf_matches_scipy) {  // scipy.stats.norm.cdf
  EXPECT_NEAR(normal_cdf(-6) / 9.865876450376946e-10, 1, 1e-12);
  EXPECT_NEAR(normal_cdf(-3), 0.0013498980316300933, 1e-16);
  EXPECT_DOUBLE_EQ(normal_cdf(0), 0.5);
  EXPECT_NEAR(normal_cdf(4), 0.9999683287581669, 1e-15);
}

TEST(Summary, matches_scipy) {  // numpy.mean, numpy.std(ddof=1), scipy.stats.sem
  const Summary s = summarise(std::vector{2.5, 3.1, 4.7, 5.0, 6.8});
  EXPECT_DOUBLE_EQ(s.mean, 4.42);
  EXPECT_DOUBLE_EQ(s.sd, 1.6961721610732796);
  EXPECT_DOUBLE_EQ(s.standard_error, 0.7585512507405151);
}

TEST(Summary, of_none_and_of_one_has_no_spread) {
  EXPECT_EQ(summarise({}).count, 0U);
  const Summary one = summarise(std::vector{7.0});
  EXPECT_EQ(one.mean, 7);
  EXPECT_EQ(one.sd, 0);
}

TEST(Summary, a_large_mean_does_not_swallow_a_small_spread) {
  EXPECT_DOUBLE_EQ(summarise(std::vector{1e15 + 1, 1e15 + 2, 1e15 + 3}).sd, 1);
}

TEST(Median, of_odd_and_even_counts) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({5}), 5);
}

TEST(Wilson, matches_scipy) {  // scipy.stats.binomtest(k, n).proportion_ci(method='wilson')
  EXPECT_NEAR(wilson(5, 1000).low, 0.0021375355273244604, 1e-14);
  EXPECT_NEAR(wilson(5, 1000).high, 0.011650955373375113, 1e-14);
  EXPECT_NEAR(wilson(11300, 65536).low, 0.16955145121928097, 1e-14);
  EXPECT_NEAR(wilson(3, 10).high, 0.6032218525388546, 1e-14);
}

TEST(Wilson, ends_are_exact) {
  EXPECT_EQ(wilson(0, 1000).low, 0);
  EXPECT_NEAR(wilson(0, 1000).high, 0.0038267584855551234, 1e-15);
  EXPECT_NEAR(wilson(10, 10).low, 0.7224672001371109, 1e-14);
  EXPECT_EQ(wilson(10, 10).high, 1);
  EXPECT_EQ(wilson(0, 0).low, 0);
  EXPECT_EQ(wilson(0, 0).high, 1);
}

TEST(Bootstrap, is_deterministic_and_brackets_the_median) {
  std::vector<double> sample;
  for (int i = 0; i < 41; ++i) sample.push_back(i * i);
  const Interval a = bootstrap_median(sample, 7);
  const Interval b = bootstrap_median(sample, 7);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  EXPECT_LE(a.low, 400);
  EXPECT_GE(a.high, 400);
  EXPECT_LT(a.low, a.high);
}

TEST(Bootstrap, covers_the_true_median_about_as_often_as_it_says) {
  Random random(11);
  int covered = 0;
  constexpr int experiments = 200;
  for (int k = 0; k < experiments; ++k) {
    std::vector<double> sample(31);
    for (double& x : sample) x = random.unit();
    const Interval interval = bootstrap_median(sample, static_cast<std::uint64_t>(k), 400);
    covered += interval.low <= 0.5 && 0.5 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(covered, 178);  // 95 % of 200 less four standard deviations
}

TEST(MannWhitney, exact_matches_scipy) {  // scipy.stats.mannwhitneyu(a, b, method='exact')
  const std::vector a{12.1, 15.3, 9.8, 14.2, 11.7, 13.9};
  const std::vector b{10.2, 8.9, 11.1, 9.5, 12.5, 7.7, 10.8};
  const RankTest test = mann_whitney(a, b);
  EXPECT_EQ(test.u, 36);
  EXPECT_NEAR(test.p_value, 0.03496503496503496, 1e-15);
  EXPECT_NEAR(test.shift, 2.8, 1e-12);  // numpy.median of all differences
  EXPECT_LE(test.shift_interval.low, test.shift);
  EXPECT_GE(test.shift_interval.high, test.shift);
}

TEST(MannWhitney, with_ties_matches_scipy) {  // method='asymptotic'
  const std::vector<double> a{1, 2, 2, 3, 4, 4, 5, 6, 7, 9};
  const std::vector<double> b{2, 3, 5, 5, 6, 8, 8, 9, 10, 11, 12};
  const RankTest test = mann_whitney(a, b);
  EXPECT_EQ(test.u, 26.5);
  EXPECT_NEAR(test.p_value, 0.047695013340120065, 1e-13);
  EXPECT_EQ(test.shift, -3);
}

TEST(MannWhitney, swapping_the_samples_mirrors_everything) {
  const std::vector a{1.0, 4.0, 6.0, 9.0};
  const std::vector b{2.0, 3.0, 11.0};
  const RankTest there = mann_whitney(a, b);
  const RankTest back = mann_whitney(b, a);
  EXPECT_EQ(there.u + back.u, 12);
  EXPECT_DOUBLE_EQ(there.p_value, back.p_value);
  EXPECT_EQ(there.shift, -back.shift);
}

TEST(MannWhitney, equal_samples_do_not_differ) {
  const std::vector<double> same(20, 3.0);
  EXPECT_EQ(mann_whitney(same, same).p_value, 1);
  EXPECT_EQ(mann_whitney(same, same).shift, 0);
}

TEST(Holm, worked_by_hand) {
  const std::vector<double> adjusted = holm(std::vector{0.01, 0.04, 0.03, 0.005});
  EXPECT_DOUBLE_EQ(adjusted[3], 0.02);
  EXPECT_DOUBLE_EQ(adjusted[0], 0.03);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.06);  // never below the one before it
  EXPECT_TRUE(holm({}).empty());
  EXPECT_EQ(holm(std::vector{0.9, 0.8})[0], 1);
}

TEST(FitAffine, matches_scipy) {  // scipy.stats.linregress
  const AffineFit fit = fit_affine(std::vector<double>{1, 2, 3, 4, 5, 6.5, 8},
                                   std::vector{2.1, 3.9, 6.2, 7.8, 10.1, 13.2, 15.7});
  EXPECT_NEAR(fit.slope, 1.9756286266924563, 1e-13);
  EXPECT_NEAR(fit.intercept, 0.10270793036750625, 1e-13);
  EXPECT_NEAR(fit.r_squared, 0.9984893710433036, 1e-13);
  EXPECT_NEAR(fit.slope_error, 0.03436588146728195, 1e-13);
}

TEST(Aicc, punishes_parameters_and_needs_enough_values) {
  EXPECT_LT(aicc(1, 20, 1), aicc(1, 20, 2));
  EXPECT_LT(aicc(0.5, 20, 2), aicc(1, 20, 2));
  EXPECT_EQ(aicc(1, 4, 2), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(aicc(0, 20, 2)));  // a perfect fit is no better than rounding
}

/// Law: counts that follow a law exactly, or up to noise far smaller than the laws differ by, are given that
/// law.
class GrowthFits : public testing::TestWithParam<std::size_t> {};

TEST_P(GrowthFits, find_the_law_the_counts_were_made_from) {
  for (const auto models : {growth_models(), depth_models()}) {
    if (GetParam() >= models.size()) continue;
    const GrowthModel& truth = models[GetParam()];
    Random random(5);
    std::vector<double> sizes;
    std::vector<double> counts;
    for (double n = 100; n < 60000; n *= 2) {
      sizes.push_back(n);
      const double exact = 3 * truth.leading(n) + 2 * truth.lower(n);
      counts.push_back(exact * (1 + 0.002 * (random.unit() - 0.5)));
    }
    const auto fits = fit_growth(models, sizes, counts);
    EXPECT_EQ(fits[0].model->name, truth.name);
    EXPECT_GT(fits[1].aicc - fits[0].aicc, 6);
    EXPECT_NEAR(fits[0].leading, 3, 0.1);
    EXPECT_EQ(fits[0].residuals.size(), sizes.size());
  }
}

INSTANTIATE_TEST_SUITE_P(All, GrowthFits, testing::Range<std::size_t>(0, 8));

TEST(GrowthFits, relative_residuals_do_not_depend_on_the_unit) {
  const std::vector<double> sizes{100, 200, 400, 800, 1600, 3200};
  std::vector<double> counts;
  std::vector<double> scaled;
  for (const double n : sizes) {
    counts.push_back(n * std::log(n) + 7 * std::sqrt(n));
    scaled.push_back(1024 * counts.back());
  }
  const auto a = fit_growth(growth_models(), sizes, counts);
  const auto b = fit_growth(growth_models(), sizes, scaled);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].model, b[i].model);
    EXPECT_NEAR(a[i].aicc, b[i].aicc, 1e-6);
  }
}

}  // namespace
}  // namespace tribunal::bench
