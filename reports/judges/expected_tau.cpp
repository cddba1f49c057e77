// Judge "expected-tau": does the mean of tau over random orders equal the exact expectation from the scopes?
//
// On one point set of N sites in general position E[tau] = sum_j P(j) T_j, T_j the triples whose open
// circumdisk holds exactly j sites and P(j) = 6/((j+1)(j+2)(j+3)) the chance that three given sites precede j
// given others. The rows are pairs on the same point set: one of the experiment `scopes` (T_j by brute force)
// and one of `tau-over-orders`.
//
// reproduced: every |mean - expectation| < sigmas * standard error; refuted: one is not; the sum is formed
// here again from the T_j, and where the experiment's own value disagrees with it there is no verdict.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribunal::reports {
namespace {

double expectation(const bench::Row& scopes) {
  double sum = 0;
  for (std::uint64_t j = 0; j + 3 <= scopes.cell.n; ++j) {
    const auto k = static_cast<double>(j);
    sum += 6 / ((k + 1) * (k + 2) * (k + 3)) * counter(scopes, "T." + std::to_string(j));
  }
  if (std::abs(sum - counter(scopes, "tau_expected")) > 1e-9 * sum)
    throw Incomplete("the experiment's own expectation is not the sum over its T_j at " + describe(scopes));
  return sum;
}

bool same_points(const bench::Cell& a, const bench::Cell& b) {
  return a.dataset == b.dataset && a.n == b.n && a.bits == b.bits && a.seed == b.seed;
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  const double sigmas = number(rule, "sigmas", 4);
  Judgement judgement;
  judgement.quantity = "largest |mean - E[tau]| in standard errors";
  judgement.bound = sigmas;
  Figure figure{"Distance of the mean of tau from its exact expectation", {"N", true}, {"|z|"}, {}};
  figure.series = {{"|mean - E[tau]| in standard errors", Mark::points, {}}, {"limit", Mark::dashed, {}}};
  double worst = 0;
  std::size_t pairs = 0;
  for (const bench::Row& scopes : rows) {
    if (scopes.cell.task != "scopes") continue;
    const auto sampled = std::find_if(rows.begin(), rows.end(), [&](const bench::Row& row) {
      return row.cell.task == "tau-over-orders" && same_points(row.cell, scopes.cell);
    });
    if (sampled == rows.end()) throw Incomplete("no tau-over-orders on the points of " + describe(scopes));
    const Sample sample = samples({&*sampled, 1}, "tau").front();
    const double expected = expectation(scopes);
    const double error = sample.summary.standard_error;
    if (!(error > 0)) throw Incomplete("tau does not vary over the orders of " + describe(*sampled));
    const double z = (sample.summary.mean - expected) / error;
    worst = std::max(worst, std::abs(z));
    ++pairs;
    figure.series[0].data.push_back(datum(sample.n, std::abs(z)));
    figure.series[1].data.push_back(datum(sample.n, sigmas));
    judgement.lines.push_back(scopes.cell.dataset + ", N = " + number_text(sample.n) + ", seed " +
                              std::to_string(scopes.cell.seed) + ": E[tau] = " + fixed_text(expected, 4) +
                              ", mean of " + std::to_string(sample.summary.count) + " orders " +
                              fixed_text(sample.summary.mean, 4) + " +- " + fixed_text(error, 4) +
                              ", z = " + fixed_text(z, 2));
  }
  if (pairs == 0) throw Incomplete("no row of the experiment scopes");
  judgement.measured = worst;
  judgement.verdict = worst < sigmas ? Verdict::reproduced : Verdict::refuted;
  const auto chances = static_cast<double>(pairs);
  judgement.p_value = std::min(1.0, 2 * chances * bench::normal_cdf(-worst));
  judgement.false_refutation = 2 * chances * bench::normal_cdf(-sigmas);
  judgement.lines.push_back("Power: an error of " + number_text(sigmas + 1.645, 4) +
                            " standard errors in the formula would have been seen with probability 95 %.");
  std::sort(figure.series[1].data.begin(), figure.series[1].data.end(),
            [](auto& a, auto& b) { return a.x < b.x; });
  judgement.figures.push_back(std::move(figure));
  return judgement;
}

constexpr std::array<Parameter, 1> parameters{{{"sigmas", ParameterKind::number, false}}};

}  // namespace

constinit const Judge expected_tau_judge{
    "expected-tau", "mean of tau over orders against the exact expectation from the scopes", parameters,
    judge};

}  // namespace tribunal::reports
