#include "bench/statistics.hpp"

#include "datasets/random.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace tribunal::bench {
namespace {

double square(double x) { return x * x; }

/// How often each value of U occurs among the C(a+b, a) equally likely rank orders: the coefficients of the
/// Gaussian binomial [a+b choose a]_q = prod_{i=1..a} (1 - q^{b+i}) / (1 - q^i).
std::vector<double> mann_whitney_counts(std::size_t a, std::size_t b) {
  std::vector<double> ways(a * b + 1, 0.0);
  ways[0] = 1;
  for (std::size_t i = 1; i <= a; ++i) {
    for (std::size_t u = ways.size(); u-- > b + i;) ways[u] -= ways[u - b - i];
    for (std::size_t u = i; u < ways.size(); ++u) ways[u] += ways[u - i];
  }
  return ways;
}

/// Twice the smaller tail, at most 1.
double exact_p_value(double u, std::size_t a, std::size_t b) {
  const std::vector<double> ways = mann_whitney_counts(a, b);
  const double smaller = std::min(u, static_cast<double>(a * b) - u);
  const auto last = ways.begin() + static_cast<std::ptrdiff_t>(smaller) + 1;
  const double tail = std::accumulate(ways.begin(), last, 0.0);
  return std::min(1.0, 2 * tail / std::accumulate(ways.begin(), ways.end(), 0.0));
}

/// Sum of t^3 - t over the groups of t equal values: the tie correction of the variance of U.
double tie_term(std::vector<double> pooled) {
  std::sort(pooled.begin(), pooled.end());
  double term = 0;
  for (std::size_t i = 0; i < pooled.size();) {
    std::size_t j = i;
    while (j < pooled.size() && pooled[j] == pooled[i]) ++j;
    const auto group = static_cast<double>(j - i);
    term += group * group * group - group;
    i = j;
  }
  return term;
}

double approximate_p_value(double u, double a, double b, double ties) {
  const double total = a + b;
  const double variance = a * b / 12 * (total + 1 - ties / (total * (total - 1)));
  if (!(variance > 0)) return 1;
  const double deviation = std::max(0.0, std::abs(u - a * b / 2) - 0.5);
  return std::min(1.0, 2 * normal_cdf(-deviation / std::sqrt(variance)));
}

/// Solves the 2x2 normal equations of y = c f + d g. Returns {c, d}; d = 0 where f and g are proportional.
std::array<double, 2> least_squares(std::span<const double> f, std::span<const double> g,
                                    std::span<const double> y) {
  // Gram-Schmidt instead of the determinant of the normal matrix, which cancels where f and g are nearly
  // parallel.
  const double gg = std::inner_product(g.begin(), g.end(), g.begin(), 0.0);
  const double slant = std::inner_product(f.begin(), f.end(), g.begin(), 0.0) / gg;
  double numerator = 0;
  double denominator = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double orthogonal = f[i] - slant * g[i];
    numerator += orthogonal * y[i];
    denominator += orthogonal * orthogonal;
  }
  const double c = numerator / denominator;
  double remainder = 0;
  for (std::size_t i = 0; i < y.size(); ++i) remainder += g[i] * (y[i] - c * f[i]);
  return {c, remainder / gg};
}

GrowthFit fit_one(const GrowthModel& model, std::span<const double> sizes, std::span<const double> counts) {
  // Dividing every equation by its count turns absolute residuals into relative ones: the right side
  // becomes 1.
  std::vector<double> f(sizes.size());
  std::vector<double> g(sizes.size());
  const std::vector<double> ones(sizes.size(), 1.0);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    f[i] = model.leading(sizes[i]) / counts[i];
    g[i] = model.lower(sizes[i]) / counts[i];
  }
  GrowthFit fit;
  fit.model = &model;
  const auto [leading, lower] = least_squares(f, g, ones);
  fit.leading = leading;
  fit.lower = lower;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    fit.residuals.push_back(1 - leading * f[i] - lower * g[i]);
    fit.rss += square(fit.residuals.back());
  }
  fit.aicc = aicc(fit.rss, sizes.size(), 2);
  return fit;
}

double constant(double /*n*/) { return 1; }
double linear(double n) { return n; }

constexpr std::array<GrowthModel, 8> totals{{
    {"N", linear, constant},
    {"N log N", [](double n) { return n * std::log(n); }, linear},
    {"N^4/3", [](double n) { return n * std::cbrt(n); }, linear},
    {"N^3/2", [](double n) { return n * std::sqrt(n); }, linear},
    {"N^5/3", [](double n) { return n * square(std::cbrt(n)); }, linear},
    {"N^2", [](double n) { return n * n; }, linear},
    {"N^2 log N", [](double n) { return n * n * std::log(n); }, linear},
    {"N^3", [](double n) { return n * n * n; }, linear},
}};

constexpr std::array<GrowthModel, 5> depths{{
    {"log N", [](double n) { return std::log(n); }, constant},
    {"log^2 N", [](double n) { return square(std::log(n)); }, constant},
    {"N^1/4", [](double n) { return std::sqrt(std::sqrt(n)); }, constant},
    {"N^1/2", [](double n) { return std::sqrt(n); }, constant},
    {"N", linear, constant},
}};

}  // namespace

double normal_cdf(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

Summary summarise(std::span<const double> sample) {
  Summary summary;
  summary.count = sample.size();
  if (sample.empty()) return summary;
  const auto count = static_cast<double>(sample.size());
  summary.mean = std::accumulate(sample.begin(), sample.end(), 0.0) / count;
  if (sample.size() < 2) return summary;
  double squares = 0;
  for (const double x : sample) squares += square(x - summary.mean);
  summary.sd = std::sqrt(squares / (count - 1));
  summary.standard_error = summary.sd / std::sqrt(count);
  return summary;
}

double median(std::vector<double> sample) {
  assert(!sample.empty());
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  if (sample.size() % 2 == 1) return *middle;
  return (*std::max_element(sample.begin(), middle) + *middle) / 2;
}

Interval wilson(std::uint64_t successes, std::uint64_t trials, double z) {
  assert(successes <= trials);
  if (trials == 0) return {0, 1};
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double scale = 1 + z * z / n;
  const double centre = (p + z * z / (2 * n)) / scale;
  const double half = z / scale * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  // At the ends of the scale the bound is exactly 0 or 1; rounding must not blur that.
  return {successes == 0 ? 0 : centre - half, successes == trials ? 1 : centre + half};
}

Interval bootstrap_median(std::span<const double> sample, std::uint64_t seed, std::size_t resamples,
                          double level) {
  assert(!sample.empty() && resamples > 0 && level > 0 && level < 1);
  Random random(seed);
  std::vector<double> medians(resamples);
  std::vector<double> resample(sample.size());
  for (double& value : medians) {
    for (double& x : resample) x = sample[random.below(sample.size())];
    value = median(resample);
  }
  std::sort(medians.begin(), medians.end());
  const auto at = [&](double quantile) {
    return medians[static_cast<std::size_t>(std::floor(quantile * static_cast<double>(resamples - 1) + 0.5))];
  };
  return {at((1 - level) / 2), at((1 + level) / 2)};
}

RankTest mann_whitney(std::span<const double> a, std::span<const double> b) {
  assert(!a.empty() && !b.empty());
  RankTest test;
  std::vector<double> differences;
  differences.reserve(a.size() * b.size());
  for (const double x : a)
    for (const double y : b) {
      test.u += x > y ? 1 : x == y ? 0.5 : 0;
      differences.push_back(x - y);
    }
  std::vector<double> pooled(a.begin(), a.end());
  pooled.insert(pooled.end(), b.begin(), b.end());
  const double ties = tie_term(std::move(pooled));
  const auto na = static_cast<double>(a.size());
  const auto nb = static_cast<double>(b.size());
  test.p_value = ties == 0 && std::min(a.size(), b.size()) <= 8 ? exact_p_value(test.u, a.size(), b.size())
                                                                : approximate_p_value(test.u, na, nb, ties);
  std::sort(differences.begin(), differences.end());
  test.shift = median(differences);
  // The k-th smallest and k-th largest difference, k from the normal approximation to U (Hollander and Wolfe
  // 1973).
  const double rank = na * nb / 2 - z95 * std::sqrt(na * nb * (na + nb + 1) / 12);
  const auto k = static_cast<std::size_t>(std::max(0.0, std::floor(rank)));
  test.shift_interval = {differences[k], differences[differences.size() - 1 - k]};
  return test;
}

std::vector<double> holm(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return p_values[i] < p_values[j]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, static_cast<double>(order.size() - i) * p_values[order[i]]);
    adjusted[order[i]] = std::min(1.0, largest);
  }
  return adjusted;
}

AffineFit fit_affine(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size() && x.size() >= 2);
  const double mean_x = summarise(x).mean;
  const double mean_y = summarise(y).mean;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += square(x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += square(y[i] - mean_y);
  }
  assert(xx > 0);
  AffineFit fit;
  fit.slope = xy / xx;
  fit.intercept = mean_y - fit.slope * mean_x;
  for (std::size_t i = 0; i < x.size(); ++i) fit.rss += square(y[i] - fit.intercept - fit.slope * x[i]);
  fit.r_squared = yy > 0 ? 1 - fit.rss / yy : 1;
  if (x.size() > 2) fit.slope_error = std::sqrt(fit.rss / static_cast<double>(x.size() - 2) / xx);
  return fit;
}

double aicc(double rss, std::size_t count, std::size_t parameters) {
  const std::size_t k = parameters + 1;
  if (count <= k + 1) return std::numeric_limits<double>::infinity();
  const auto m = static_cast<double>(count);
  const auto kk = static_cast<double>(k);
  constexpr double rounding = 0x1p-52;
  const double variance = std::max(rss / m, rounding * rounding);
  return m * std::log(variance) + 2 * kk + 2 * kk * (kk + 1) / (m - kk - 1);
}

std::span<const GrowthModel> growth_models() { return totals; }
std::span<const GrowthModel> depth_models() { return depths; }

std::vector<GrowthFit> fit_growth(std::span<const GrowthModel> models, std::span<const double> sizes,
                                  std::span<const double> counts) {
  assert(sizes.size() == counts.size() && sizes.size() >= 5);
  std::vector<GrowthFit> fits;
  for (const GrowthModel& model : models) fits.push_back(fit_one(model, sizes, counts));
  std::stable_sort(fits.begin(), fits.end(), [](const auto& a, const auto& b) { return a.aicc < b.aicc; });
  return fits;
}

}  // namespace tribunal::bench
