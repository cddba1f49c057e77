// Judge "run-identities": do the counters of each run satisfy the exact identities of incremental insertion
// with ghosts?
//
// N distinct sites spanning the plane, E of them landing on an edge, F flips (ghost edges included):
//   tau = tau_with_ghosts - 2 outside_hull          every algorithm
//   triangles = 2N - 2 - hull                       every algorithm
//   tau_with_ghosts = 3(N - 2) + E + F              Green-Sibson
//   created = 4 + 3(N - 3) + E + 2F                 Green-Sibson: 4 at the start, 3 per site, 1 more on an
//   edge, 2 a flip
//   history.nodes = created                         Green-Sibson with a history
//   conflict_tests = created - 4                    Green-Sibson: each new triangle is tested once, the first
//   4 never
// reproduced: all hold in all runs; refuted: one fails once. Runs that end in dimension 0 or 1 have no
// triangles and are left out, with their number.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace tribunal::reports {
namespace {

/// left = right, by name, per run.
struct Identity {
  std::string_view name;
  bool green_sibson_only;
  double (*left)(const bench::Row& row);
  double (*right)(const bench::Row& row);
};

double sites(const bench::Row& row) { return counter(row, "points") - counter(row, "duplicates"); }

constexpr std::array<Identity, 6> identities{{
    {"tau = tau_with_ghosts - 2 outside_hull", false,
     [](const bench::Row& row) { return counter(row, "tau"); },
     [](const bench::Row& row) {
       return counter(row, "tau_with_ghosts") - 2 * counter(row, "outside_hull");
     }},
    {"triangles = 2N - 2 - hull", false, [](const bench::Row& row) { return counter(row, "triangles"); },
     [](const bench::Row& row) { return 2 * sites(row) - 2 - counter(row, "hull"); }},
    {"tau_with_ghosts = 3(N - 2) + E + F", true,
     [](const bench::Row& row) { return counter(row, "tau_with_ghosts"); },
     [](const bench::Row& row) {
       return 3 * (sites(row) - 2) + counter(row, "on_edge") + counter(row, "flips");
     }},
    {"created = 4 + 3(N - 3) + E + 2F", true, [](const bench::Row& row) { return counter(row, "created"); },
     [](const bench::Row& row) {
       return 4 + 3 * (sites(row) - 3) + counter(row, "on_edge") + 2 * counter(row, "flips");
     }},
    {"history.nodes = created", true,
     [](const bench::Row& row) {
       return counter(row, row.cell.parameters.contains("location") ? "created" : "history.nodes");
     },
     [](const bench::Row& row) { return counter(row, "created"); }},
    {"conflict_tests = created - 4", true,
     [](const bench::Row& row) { return counter(row, "conflict_tests"); },
     [](const bench::Row& row) { return counter(row, "created") - 4; }},
}};

Judgement judge(const Rule& /*rule*/, Rows rows) {
  require_finished(rows);
  std::uint64_t flat = 0;
  std::uint64_t checked = 0;
  std::uint64_t violated = 0;
  std::map<std::string_view, std::uint64_t> held;
  std::string first;
  for (const bench::Row& row : rows) {
    if (counter(row, "dimension") < 2) {
      ++flat;
      continue;
    }
    for (const Identity& identity : identities) {
      if (identity.green_sibson_only && row.cell.task != "green-sibson") continue;
      const double left = identity.left(row);
      const double right = identity.right(row);
      ++checked;
      if (left == right) {
        ++held[identity.name];
      } else if (violated++ == 0) {
        first = std::string(identity.name) + " fails, " + number_text(left) + " against " +
                number_text(right) + ": " + describe(row) + ", seed " + std::to_string(row.cell.seed);
      }
    }
  }
  if (checked == 0) throw Incomplete("no run spans the plane");
  Judgement judgement;
  judgement.quantity = "violated identities";
  judgement.measured = static_cast<double>(violated);
  judgement.bound = 0;
  judgement.verdict = violated == 0 ? Verdict::reproduced : Verdict::refuted;
  for (const auto& [name, count] : held)
    judgement.lines.push_back(std::string(name) + ": held in " + std::to_string(count) + " runs");
  judgement.lines.push_back(std::to_string(checked) + " identities checked, " + std::to_string(violated) +
                            " violated; " + std::to_string(flat) + " runs without triangles left out.");
  if (violated > 0) judgement.lines.push_back("First: " + first + ".");
  return judgement;
}

}  // namespace

constinit const Judge run_identities_judge{
    "run-identities", "exact identities of the counters of each run", {}, judge};

}  // namespace tribunal::reports
