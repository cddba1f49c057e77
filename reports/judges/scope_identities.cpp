// Judge "scope-identities": do the scopes T_j satisfy the exact identities of point sets in general position?
//
// T_j is the number of triples whose open circumdisk holds exactly j of the N sites. For every j of every
// row: T_j + T_{N-3-j} = 2(j+1)(N-2-j); T_j <= (j+1)(2N - 5j/2 - 5) where j+1 <= N/3; all T_j together are
// C(N,3). reproduced: no violation; refuted: one is enough. No statistics: these are counts.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

namespace tribunal::reports {
namespace {

struct Tally {
  std::uint64_t checked = 0;
  std::uint64_t violated = 0;
  std::string first;

  void check(bool holds, const std::string& what) {
    ++checked;
    if (holds) return;
    if (violated++ == 0) first = what;
  }
};

void check_row(const bench::Row& row, Tally& tally) {
  const auto n = static_cast<double>(row.cell.n);
  if (row.cell.n < 3) throw Incomplete("fewer than 3 sites have no scopes");
  double total = 0;
  for (std::uint64_t j = 0; j + 3 <= row.cell.n; ++j) {
    const auto k = static_cast<double>(j);
    const double here = counter(row, "T." + std::to_string(j));
    const double mirrored = counter(row, "T." + std::to_string(row.cell.n - 3 - j));
    const std::string where = " at j = " + std::to_string(j) + ", N = " + std::to_string(row.cell.n) +
                              ", seed " + std::to_string(row.cell.seed);
    total += here;
    tally.check(here + mirrored == 2 * (k + 1) * (n - 2 - k),
                "T_j + T_{N-3-j} is " + number_text(here + mirrored) + where);
    if (3 * (j + 1) <= row.cell.n)
      tally.check(here <= (k + 1) * (2 * n - 2.5 * k - 5),
                  "T_j = " + number_text(here) + " exceeds its bound" + where);
  }
  tally.check(total == n * (n - 1) * (n - 2) / 6,
              "the T_j do not add up to C(N,3), N = " + std::to_string(row.cell.n));
}

Judgement judge(const Rule& /*rule*/, Rows rows) {
  require_finished(rows);
  Tally tally;
  for (const bench::Row& row : rows)
    if (row.cell.task == "scopes") check_row(row, tally);
  if (tally.checked == 0) throw Incomplete("no row of the experiment scopes");
  Judgement judgement;
  judgement.quantity = "violated identities";
  judgement.measured = static_cast<double>(tally.violated);
  judgement.bound = 0;
  judgement.verdict = tally.violated == 0 ? Verdict::reproduced : Verdict::refuted;
  judgement.lines.push_back(std::to_string(tally.checked) + " identities checked on " +
                            std::to_string(rows.size()) + " point sets, " + std::to_string(tally.violated) +
                            " violated.");
  if (tally.violated > 0) judgement.lines.push_back("First: " + tally.first + ".");
  return judgement;
}

}  // namespace

constinit const Judge scope_identities_judge{
    "scope-identities", "exact identities of the scopes T_j", {}, judge};

}  // namespace tribunal::reports
