// The statistics the bench and the judges use: few, classical, each with its source.
//
// Counters are compared exactly and need none of this; it serves what is random (orders, datasets) or noisy
// (times).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal::bench {

/// A closed interval of the quantity it is attached to, in that quantity's unit.
struct Interval {
  double low = 0;
  double high = 0;
};

/// Two-sided 95 % quantile of the standard normal distribution.
inline constexpr double z95 = 1.959963984540054;

/// P(Z <= z) of the standard normal distribution, to full relative accuracy in the lower tail.
double normal_cdf(double z);

/// A sample in three numbers. `sd` has the divisor count - 1; both spreads are 0 where count < 2.
struct Summary {
  std::size_t count = 0;
  double mean = 0;
  double sd = 0;
  double standard_error = 0;  ///< sd / sqrt(count)
};

/// Two passes (mean, then squared deviations from it), so that a large mean does not swallow a small spread.
/// O(n).
Summary summarise(std::span<const double> sample);

/// The middle value, or the mean of the two middle ones. Not empty. O(n).
double median(std::vector<double> sample);

/// Wilson's score interval for a probability from `successes` of `trials` (Wilson 1927); [0, 1] where there
/// are no trials. Unlike p +- z sqrt(p(1-p)/n) it stays meaningful at 0 successes, which is where an exact
/// backend must be.
Interval wilson(std::uint64_t successes, std::uint64_t trials, double z = z95);

/// Percentile bootstrap of the median (Efron 1979): `resamples` resamples drawn with `seed`, quantiles at
/// (1 -+ level)/2. Not empty; same arguments, same interval. O(resamples * n).
Interval bootstrap_median(std::span<const double> sample, std::uint64_t seed, std::size_t resamples = 2000,
                          double level = 0.95);

/// Do two samples differ in location, and by how much?
struct RankTest {
  double u = 0;             ///< pairs (a, b) with a > b, ties counting one half
  double p_value = 1;       ///< two-sided
  double shift = 0;         ///< Hodges-Lehmann: the median of all differences a - b
  Interval shift_interval;  ///< 95 %, from the order statistics of those differences
};

/// Mann-Whitney U test (Mann and Whitney 1947) with the shift of Hodges and Lehmann (1963). Exact null
/// distribution where the smaller sample has at most 8 values and there are no ties; otherwise the normal
/// approximation with continuity and tie correction. Neither sample empty. O(|a| |b|).
RankTest mann_whitney(std::span<const double> a, std::span<const double> b);

/// Holm's step-down adjustment (1979): the adjusted values, in the order given, may each be compared with the
/// level wanted for the whole family.
std::vector<double> holm(std::span<const double> p_values);

/// y = intercept + slope x by least squares.
struct AffineFit {
  double intercept = 0;
  double slope = 0;
  double slope_error = 0;  ///< standard error of the slope; 0 where there are only two points
  double r_squared = 0;    ///< share of the variance explained; 1 where all y are equal
  double rss = 0;          ///< sum of squared residuals
};

/// Equally many x and y, at least two, not all x equal. O(n).
AffineFit fit_affine(std::span<const double> x, std::span<const double> y);

/// Akaike's criterion with the small-sample term (Hurvich and Tsai 1989) for a least-squares fit to `count`
/// values with `parameters` coefficients, the variance counting as one more: count ln(rss / count) + 2k +
/// 2k(k+1)/(count-k-1). Infinite where count <= k + 1. `rss` of relative residuals below rounding counts as
/// rounding.
double aicc(double rss, std::size_t count, std::size_t parameters);

/// A law of growth that may be claimed of a count: leading term c f(N), plus one lower-order term.
struct GrowthModel {
  std::string_view name;  ///< e.g. "N log N"
  double (*leading)(double n);
  double (*lower)(double n);
};

/// For totals: N, N log N, N^4/3, N^3/2, N^5/3, N^2, N^2 log N, N^3, each with the lower-order term N (N
/// itself with a constant): every exponent that some algorithm of the field has.
std::span<const GrowthModel> growth_models();

/// For depths and other quantities per site: log N, log^2 N, N^1/4, N^1/2, N, each with a constant.
std::span<const GrowthModel> depth_models();

/// How well one law describes counts over sizes.
struct GrowthFit {
  const GrowthModel* model = nullptr;
  double leading = 0;             ///< coefficient of the leading term
  double lower = 0;               ///< coefficient of the lower-order term
  double rss = 0;                 ///< of the relative residuals
  double aicc = 0;                ///< smaller is better; differences matter, the level does not
  std::vector<double> residuals;  ///< (count - fit) / count, in the order given

  [[nodiscard]] double at(double n) const { return leading * model->leading(n) + lower * model->lower(n); }
};

/// Rival laws fitted to the same counts, best first. Residuals are relative, so that each size weighs the
/// same: absolute ones would let the largest N decide alone, logarithms would bend the lower-order term.
/// Equally many sizes and counts, all positive, at least 5 different sizes (fewer cannot tell two-parameter
/// laws apart).
std::vector<GrowthFit> fit_growth(std::span<const GrowthModel> models, std::span<const double> sizes,
                                  std::span<const double> counts);

}  // namespace tribunal::bench
