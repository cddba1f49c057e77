// Judge "mean-below-bound": is a count's mean over random orders at most a closed form of N?
//
// One sample per kind of run (algorithm, backend, dataset, order, N): mean m and standard error e over its
// runs. refuted: m - sigmas e > bound for one of them; reproduced: m + sigmas e <= bound for all;
// inconclusive: an interval straddles its bound. The quantile is the normal one, so fewer than 20 runs carry
// no verdict. Single runs say nothing either way: the bound is on the expectation.
#include "reports/judges/bounds.hpp"
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>

namespace tribunal::reports {
namespace {

constexpr std::size_t fewest_runs = 20;

/// A sample beside the bound of its size.
struct Standing {
  Sample sample;
  double bound = 0;
  bench::Interval interval;  ///< mean -+ sigmas standard errors

  [[nodiscard]] bool above() const { return interval.low > bound; }
  [[nodiscard]] bool below() const { return interval.high <= bound; }
  [[nodiscard]] double excess() const { return sample.summary.mean - bound; }
};

std::vector<Standing> standings(const Rule& rule, Rows rows, const Bound& bound) {
  const double sigmas = number(rule, "sigmas", 3);
  std::vector<Standing> result;
  for (Sample& sample : samples(rows, text(rule, "counter", "tau"))) {
    if (sample.summary.count < fewest_runs)
      throw Incomplete("only " + std::to_string(sample.summary.count) + " runs of " + sample.label);
    const double half = sigmas * sample.summary.standard_error;
    const bench::Interval interval{sample.summary.mean - half, sample.summary.mean + half};
    const double at = bound.at(static_cast<std::uint64_t>(sample.n));
    result.push_back({std::move(sample), at, interval});
  }
  return result;
}

std::string line(const Standing& standing) {
  const bench::Summary& summary = standing.sample.summary;
  return standing.sample.label + ": mean of " + std::to_string(summary.count) + " runs " +
         fixed_text(summary.mean, 2) + " +- " + fixed_text(summary.standard_error, 2) + " (sd " +
         fixed_text(summary.sd, 1) + "), " + fixed_text(summary.mean / standing.bound, 4) + " of the bound " +
         fixed_text(standing.bound, 3);
}

Figure ratio_figure(const std::vector<Standing>& found, const Bound& bound) {
  Figure figure{"Mean over the bound " + std::string(bound.formula), {"N", true}, {"mean / bound"}, {}};
  Series means{"measured", Mark::points, {}};
  Series limit{"bound", Mark::dashed, {}};
  for (const Standing& s : found) {
    means.data.push_back(
        {s.sample.n, s.sample.summary.mean / s.bound, s.interval.low / s.bound, s.interval.high / s.bound});
    limit.data.push_back(datum(s.sample.n, 1));
  }
  std::sort(limit.data.begin(), limit.data.end(), [](const Datum& a, const Datum& b) { return a.x < b.x; });
  figure.series = {std::move(means), std::move(limit)};
  return figure;
}

Verdict verdict(const std::vector<Standing>& found) {
  if (std::any_of(found.begin(), found.end(), [](const Standing& s) { return s.above(); }))
    return Verdict::refuted;
  if (std::all_of(found.begin(), found.end(), [](const Standing& s) { return s.below(); }))
    return Verdict::reproduced;
  return Verdict::inconclusive;
}

/// The sample a reader is shown: of the size the claim names, but the worst where the claim does not stand.
const Standing& headline(const Rule& rule, const std::vector<Standing>& found, Verdict verdict) {
  const auto worst = std::max_element(found.begin(), found.end(), [](const Standing& a, const Standing& b) {
    return a.excess() / a.bound < b.excess() / b.bound;
  });
  if (verdict != Verdict::reproduced) return *worst;
  const double size = number(rule, "headline", 0);
  const auto named =
      std::find_if(found.begin(), found.end(), [&](const Standing& s) { return s.sample.n == size; });
  return named == found.end() ? *worst : *named;
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  const Bound* bound = find_bound(text(rule, "bound", ""));
  if (bound == nullptr) throw Incomplete("no bound is named \"" + text(rule, "bound", "") + "\"");
  const double sigmas = number(rule, "sigmas", 3);
  const std::vector<Standing> found = standings(rule, rows, *bound);
  Judgement judgement;
  judgement.verdict = verdict(found);
  const Standing& shown = headline(rule, found, judgement.verdict);
  judgement.quantity = "mean of " + text(rule, "counter", "tau") + " at N = " + number_text(shown.sample.n);
  judgement.measured = shown.sample.summary.mean;
  judgement.interval = shown.interval;
  judgement.bound = shown.bound;
  double smallest_p = 1;
  for (const Standing& standing : found) {
    judgement.lines.push_back(line(standing));
    const double error = standing.sample.summary.standard_error;
    const double p = error > 0               ? bench::normal_cdf(-standing.excess() / error)
                     : standing.excess() > 0 ? 0
                                             : 1;
    smallest_p = std::min(smallest_p, p);
  }
  const auto chances = static_cast<double>(found.size());
  judgement.p_value = std::min(1.0, chances * smallest_p);
  judgement.false_refutation = chances * bench::normal_cdf(-sigmas);
  judgement.lines.push_back("Power: at N = " + number_text(shown.sample.n) + " a mean of " +
                            fixed_text((sigmas + 1.645) * shown.sample.summary.standard_error, 2) +
                            " above the bound would have been refuted with probability 95 %.");
  judgement.figures.push_back(ratio_figure(found, *bound));
  return judgement;
}

constexpr std::array<Parameter, 4> parameters{{{"bound", ParameterKind::text, true},
                                               {"counter", ParameterKind::text, false},
                                               {"sigmas", ParameterKind::number, false},
                                               {"headline", ParameterKind::number, false}}};

}  // namespace

constinit const Judge mean_below_bound_judge{
    "mean-below-bound", "mean of a count over random orders against an upper bound", parameters, judge};

}  // namespace tribunal::reports
