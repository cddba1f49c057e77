// Judge "exact-signs": does a backend that promises exactness return the sign of the exact determinant on
// every query?
//
// Rows of the experiment `sign-differential`: counters `queries` and `wrong` against an oracle that shares no
// code. refuted: one wrong sign of a backend of `exact`; reproduced: none in all queries. What remains
// possible is stated as the Wilson limit of the error rate on queries of this kind. Other backends are shown
// and not judged.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace tribunal::reports {
namespace {

struct Tally {
  std::uint64_t queries = 0;
  std::uint64_t wrong = 0;
};

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  const std::vector<std::string> exact = texts(rule, "exact");
  std::map<std::string, Tally> tallies;
  for (const bench::Row& row : rows) {
    Tally& tally = tallies[row.cell.backend];
    tally.queries += static_cast<std::uint64_t>(counter(row, "queries"));
    tally.wrong += static_cast<std::uint64_t>(counter(row, "wrong"));
  }
  Judgement judgement;
  Tally all;
  for (const std::string& backend : exact) {
    if (!tallies.contains(backend)) throw Incomplete("no rows of backend " + backend);
    all.queries += tallies[backend].queries;
    all.wrong += tallies[backend].wrong;
  }
  if (all.queries == 0) throw Incomplete("no queries were asked");
  for (const auto& [backend, tally] : tallies) {
    const bool judged = std::find(exact.begin(), exact.end(), backend) != exact.end();
    judgement.lines.push_back(backend + (judged ? "" : " (not judged)") + ": " + std::to_string(tally.wrong) +
                              " of " + std::to_string(tally.queries) + " signs wrong");
  }
  judgement.quantity = "share of wrong signs";
  judgement.measured = static_cast<double>(all.wrong) / static_cast<double>(all.queries);
  judgement.interval = bench::wilson(all.wrong, all.queries);
  judgement.bound = 0;
  judgement.verdict = all.wrong == 0 ? Verdict::reproduced : Verdict::refuted;
  judgement.lines.push_back("Power: an error rate of " + percent_text(judgement.interval->high) +
                            " or more on such queries is excluded at 95 %.");
  return judgement;
}

constexpr std::array<Parameter, 1> parameters{{{"exact", ParameterKind::texts, true}}};

}  // namespace

constinit const Judge exact_signs_judge{
    "exact-signs", "signs of exact backends against an independent oracle", parameters, judge};

}  // namespace tribunal::reports
