// Judge "failure-rates": do algorithms fail under inexact predicates where the same code never fails under
// exact ones?
//
// A run fails by a wrong result: non_delaunay, invalid_topology, missing_site, inconsistent_predicate, loop
// or crash. A refusal (out_of_domain, refused_input) is no answer and is counted apart; timeout and
// out_of_memory say nothing of the predicate. refuted: a backend of `exact` fails once; inconclusive: none
// does, but no backend of `suspects` fails either, or an exact one ran out of time or memory; reproduced:
// every suspect fails, no exact one does. Wilson intervals at 95 %.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace tribunal::reports {
namespace {

struct Tally {
  std::uint64_t runs = 0;  ///< that gave a result, right or wrong
  std::uint64_t failed = 0;
  std::uint64_t refused = 0;
  std::uint64_t unfinished = 0;
  std::map<std::string, std::uint64_t> kinds;

  void add(const bench::Row& row) {
    if (row.outcome == "out_of_domain" || row.outcome == "refused_input") {
      ++refused;
    } else if (row.outcome == "timeout" || row.outcome == "out_of_memory") {
      ++unfinished;
    } else {
      ++runs;
      if (row.outcome != "ok") {
        ++failed;
        ++kinds[row.outcome];
      }
    }
  }

  [[nodiscard]] double rate() const {
    return runs == 0 ? 0 : static_cast<double>(failed) / static_cast<double>(runs);
  }
};

std::string line(const std::string& backend, const Tally& tally) {
  const bench::Interval interval = bench::wilson(tally.failed, tally.runs);
  std::string text = backend + ": " + std::to_string(tally.failed) + " of " + std::to_string(tally.runs) +
                     " runs failed, " + percent_text(tally.rate()) + " [" + percent_text(interval.low) +
                     ", " + percent_text(interval.high) + "]";
  for (const auto& [kind, count] : tally.kinds) text += ", " + kind + " " + std::to_string(count);
  if (tally.refused > 0) text += "; " + std::to_string(tally.refused) + " refused";
  if (tally.unfinished > 0) text += "; " + std::to_string(tally.unfinished) + " out of time or memory";
  return text;
}

Verdict verdict(const std::vector<Tally>& suspects, const std::vector<Tally>& exact) {
  const auto fails = [](const Tally& tally) { return tally.failed > 0; };
  if (std::any_of(exact.begin(), exact.end(), fails)) return Verdict::refuted;
  const bool sound = std::all_of(exact.begin(), exact.end(),
                                 [](const Tally& tally) { return tally.unfinished == 0 && tally.runs > 0; });
  return sound && std::all_of(suspects.begin(), suspects.end(), fails) ? Verdict::reproduced
                                                                       : Verdict::inconclusive;
}

Tally together(const std::vector<Tally>& tallies) {
  Tally sum;
  for (const Tally& tally : tallies) {
    sum.runs += tally.runs;
    sum.failed += tally.failed;
  }
  return sum;
}

void list_datasets(Rows rows, const std::vector<std::string>& suspects, Judgement& judgement) {
  std::map<std::string, Tally> by_dataset;
  for (const bench::Row& row : rows)
    if (std::find(suspects.begin(), suspects.end(), row.cell.backend) != suspects.end())
      by_dataset[row.cell.dataset].add(row);
  std::string text;
  for (const auto& [dataset, tally] : by_dataset)
    text += (text.empty() ? "" : ", ") + dataset + " " + std::to_string(tally.failed) + "/" +
            std::to_string(tally.runs);
  judgement.lines.push_back("Failures of the inexact by dataset: " + text + ".");
}

Judgement judge(const Rule& rule, Rows rows) {
  std::map<std::string, Tally> tallies;
  for (const bench::Row& row : rows) tallies[row.cell.backend].add(row);
  Judgement judgement;
  const auto collect = [&](std::string_view parameter) {
    std::vector<Tally> group;
    for (const std::string& backend : texts(rule, parameter)) {
      if (!tallies.contains(backend)) throw Incomplete("no rows of backend " + backend);
      group.push_back(tallies[backend]);
      judgement.lines.push_back(line(backend, group.back()));
    }
    return group;
  };
  const std::vector<Tally> suspects = collect("suspects");
  const std::vector<Tally> exact = collect("exact");
  const Tally wrong = together(suspects);
  const Tally right = together(exact);
  judgement.verdict = verdict(suspects, exact);
  judgement.quantity = "failure rate of the inexact; the bound is the upper limit for the exact";
  judgement.measured = wrong.rate();
  judgement.interval = bench::wilson(wrong.failed, wrong.runs);
  judgement.bound = bench::wilson(right.failed, right.runs).high;
  list_datasets(rows, texts(rule, "suspects"), judgement);
  judgement.lines.push_back("Power: with " + std::to_string(right.runs) + " exact runs, a failure rate of " +
                            percent_text(*judgement.bound) + " or more is excluded at 95 %.");
  return judgement;
}

constexpr std::array<Parameter, 2> parameters{
    {{"suspects", ParameterKind::texts, true}, {"exact", ParameterKind::texts, true}}};

}  // namespace

constinit const Judge failure_rates_judge{
    "failure-rates", "wrong results under inexact predicates, none under exact ones", parameters, judge};

}  // namespace tribunal::reports
