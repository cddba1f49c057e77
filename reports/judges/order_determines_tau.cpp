// Judge "order-determines-tau": do algorithms that insert the same sites in the same order report the same
// tau and the same mesh?
//
// In general position the Delaunay triangulation after each insertion is unique, so tau, tau_with_ghosts and
// the final mesh depend on points and order only, not on how the triangulation is repaired. Runs that met a
// tie (counter `ties`) are left out, with their number. reproduced: all agree; refuted: two runs differ; no
// statistics.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <array>
#include <set>
#include <tuple>

namespace tribunal::reports {
namespace {

using Input = std::tuple<std::string, std::uint64_t, int, std::uint64_t, std::string, std::uint64_t>;

Input input_of(const bench::Cell& cell) {
  return {cell.dataset, cell.n, cell.bits, cell.seed, cell.order, cell.order_seed};
}

Judgement judge(const Rule& /*rule*/, Rows rows) {
  require_finished(rows);
  std::map<Input, std::vector<const bench::Row*>> inputs;
  std::uint64_t tied = 0;
  for (const bench::Row& row : rows) {
    if (counter(row, "ties") > 0)
      ++tied;
    else
      inputs[input_of(row.cell)].push_back(&row);
  }
  std::uint64_t compared = 0;
  std::uint64_t different = 0;
  std::string first;
  std::set<std::string> tasks;
  for (const auto& [input, runs] : inputs)
    for (std::size_t i = 1; i < runs.size(); ++i) {
      const bench::Row& a = *runs[0];
      const bench::Row& b = *runs[i];
      tasks.insert({a.cell.task, b.cell.task});
      ++compared;
      const bool same = counter(a, "tau") == counter(b, "tau") &&
                        counter(a, "tau_with_ghosts") == counter(b, "tau_with_ghosts") &&
                        a.digest == b.digest;
      if (!same && different++ == 0)
        first = describe(a) + " against " + describe(b) + ": tau " + number_text(counter(a, "tau")) +
                " and " + number_text(counter(b, "tau")) + (a.digest == b.digest ? "" : ", different meshes");
    }
  if (compared == 0) throw Incomplete("no two tie-free runs on the same sites in the same order");
  Judgement judgement;
  judgement.quantity = "pairs of runs that differ";
  judgement.measured = static_cast<double>(different);
  judgement.bound = 0;
  judgement.verdict = different == 0 ? Verdict::reproduced : Verdict::refuted;
  std::string names;
  for (const std::string& task : tasks) names += (names.empty() ? "" : ", ") + task;
  judgement.lines.push_back(std::to_string(compared) + " pairs of runs of " + names + " compared on " +
                            std::to_string(inputs.size()) + " inputs, " + std::to_string(different) +
                            " differ; " + std::to_string(tied) + " runs with ties left out.");
  if (different > 0) judgement.lines.push_back("First: " + first + ".");
  return judgement;
}

}  // namespace

constinit const Judge order_determines_tau_judge{
    "order-determines-tau", "same sites in the same order: same tau and mesh by every algorithm", {}, judge};

}  // namespace tribunal::reports
