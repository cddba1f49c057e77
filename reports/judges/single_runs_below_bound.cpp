// Judge "single-runs-below-bound": does every single run obey the bound on the expectation?
//
// refuted: at least one run exceeds it (a counterexample needs no statistics); otherwise inconclusive,
// because no number of obedient runs proves a statement about all of them: the lines then say which rate
// would have been seen. Rows of `tau-over-orders` bring many runs each; their bound is recomputed here and
// must be the same.
#include "reports/judges/bounds.hpp"
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribunal::reports {
namespace {

struct Tally {
  std::uint64_t runs = 0;
  std::uint64_t above = 0;
  double largest = 0;
};

void add_orders(Tally& tally, const bench::Row& row, double bound) {
  if (std::abs(counter(row, "tau_bound") - bound) > 1e-9 * bound)
    throw Incomplete("the experiment counted against another bound at " + describe(row));
  tally.runs += static_cast<std::uint64_t>(counter(row, "orders"));
  tally.above += static_cast<std::uint64_t>(counter(row, "exceeding"));
  tally.largest = std::max(tally.largest, counter(row, "tau_max"));
}

void add_run(Tally& tally, const bench::Row& row, double bound) {
  const double tau = counter(row, "tau");
  ++tally.runs;
  tally.above += tau > bound ? 1 : 0;
  tally.largest = std::max(tally.largest, tau);
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  const Bound* bound = find_bound(text(rule, "bound", "tau"));
  if (bound == nullptr) throw Incomplete("no bound is named \"" + text(rule, "bound", "") + "\"");
  Judgement judgement;
  Tally all;
  for (const auto& [n, group] : by_size(rows)) {
    const double at = bound->at(n);
    Tally tally;
    for (const bench::Row& row : group)
      row.cell.task == "tau-over-orders" ? add_orders(tally, row, at) : add_run(tally, row, at);
    judgement.lines.push_back("N = " + std::to_string(n) + ": " + std::to_string(tally.above) + " of " +
                              std::to_string(tally.runs) + " runs above " + fixed_text(at, 3) +
                              ", the largest " + number_text(tally.largest));
    all.runs += tally.runs;
    all.above += tally.above;
  }
  judgement.quantity = "share of runs above the bound";
  judgement.measured = static_cast<double>(all.above) / static_cast<double>(all.runs);
  judgement.interval = bench::wilson(all.above, all.runs);
  judgement.bound = 0;
  judgement.verdict = all.above > 0 ? Verdict::refuted : Verdict::inconclusive;
  if (all.above > 0) judgement.p_value = 0;
  const double visible = 1 - std::pow(0.05, 1 / static_cast<double>(all.runs));
  judgement.lines.push_back("Power: a share of " + percent_text(visible) +
                            " would have shown itself at least once with probability 95 %.");
  return judgement;
}

constexpr std::array<Parameter, 1> parameters{{{"bound", ParameterKind::text, false}}};

}  // namespace

constinit const Judge single_runs_below_bound_judge{
    "single-runs-below-bound", "every single run against the bound on the expectation", parameters, judge};

}  // namespace tribunal::reports
