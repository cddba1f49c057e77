// Judge "mean-at-value": is a count's mean over random orders what a closed form predicts, both ways?
//
// Per sample: mean m, standard error e, prediction v, tolerance t = tolerance * v for what the closed form
// itself neglects. reproduced: m -+ sigmas e lies within v -+ t for all; refuted: it lies wholly outside for
// one; inconclusive: it straddles the edge of the band.
#include "reports/judges/bounds.hpp"
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribunal::reports {
namespace {

Verdict standing(const bench::Interval& measured, double value, double tolerance) {
  if (measured.low >= value - tolerance && measured.high <= value + tolerance) return Verdict::reproduced;
  if (measured.low > value + tolerance || measured.high < value - tolerance) return Verdict::refuted;
  return Verdict::inconclusive;
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  const Bound* value = find_bound(text(rule, "value", ""));
  if (value == nullptr) throw Incomplete("no value is named \"" + text(rule, "value", "") + "\"");
  const double sigmas = number(rule, "sigmas", 3);
  const std::string name = text(rule, "counter", "tau");
  Judgement judgement;
  judgement.verdict = Verdict::reproduced;
  double furthest = -1;
  double smallest_p = 1;
  const std::vector<Sample> found = samples(rows, name);
  for (const Sample& sample : found) {
    if (sample.summary.count < 20)
      throw Incomplete("only " + std::to_string(sample.summary.count) + " runs of " + sample.label);
    const double at = value->at(static_cast<std::uint64_t>(sample.n));
    const double tolerance = number(rule, "tolerance", 0) * at;
    const double error = sample.summary.standard_error;
    const bench::Interval interval{sample.summary.mean - sigmas * error,
                                   sample.summary.mean + sigmas * error};
    const Verdict here = standing(interval, at, tolerance);
    if (here == Verdict::refuted || judgement.verdict == Verdict::reproduced) judgement.verdict = here;
    const double distance = std::abs(sample.summary.mean - at);
    if (error > 0)
      smallest_p = std::min(smallest_p, 2 * bench::normal_cdf(-std::max(0.0, distance - tolerance) / error));
    judgement.lines.push_back(sample.label + ": mean of " + std::to_string(sample.summary.count) + " runs " +
                              fixed_text(sample.summary.mean, 2) + " +- " + fixed_text(error, 2) +
                              ", predicted " + fixed_text(at, 2) + " -+ " + fixed_text(tolerance, 2));
    if (distance / at <= furthest) continue;
    furthest = distance / at;
    judgement.quantity = "mean of " + name + " at N = " + number_text(sample.n);
    judgement.measured = sample.summary.mean;
    judgement.interval = interval;
    judgement.bound = at;
  }
  const auto chances = static_cast<double>(found.size());
  judgement.p_value = std::min(1.0, chances * smallest_p);
  judgement.false_refutation = 2 * chances * bench::normal_cdf(-sigmas);
  return judgement;
}

constexpr std::array<Parameter, 4> parameters{{{"value", ParameterKind::text, true},
                                               {"counter", ParameterKind::text, false},
                                               {"tolerance", ParameterKind::number, false},
                                               {"sigmas", ParameterKind::number, false}}};

}  // namespace

constinit const Judge mean_at_value_judge{
    "mean-at-value", "mean of a count over random orders against its predicted value", parameters, judge};

}  // namespace tribunal::reports
