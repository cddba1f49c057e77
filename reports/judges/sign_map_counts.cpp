// Judge "sign-map-counts": does a backend err on the grid of neighbouring doubles on exactly the published
// pixels' number?
//
// Rows of the experiment `sign-map`. The rule's `expected` is a list of {backend, figure, false_zero,
// inverted, false_nonzero}. Arithmetic without contraction is deterministic, so equality is exact: reproduced
// where all numbers are the stated ones, refuted where one differs. Backends without an entry are shown and
// not judged.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>

namespace tribunal::reports {
namespace {

constexpr std::array<const char*, 3> kinds{"false_zero", "inverted", "false_nonzero"};

std::string figure_of(const bench::Row& row) {
  const auto found = row.cell.parameters.find("figure");
  return found == row.cell.parameters.end() ? "2a" : found->second;
}

std::string counts_text(const bench::Row& row) {
  return number_text(counter(row, "false_zero")) + " false zeros, " + number_text(counter(row, "inverted")) +
         " inverted, " + number_text(counter(row, "false_nonzero")) + " false non-zeros of " +
         number_text(counter(row, "pixels"));
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  Judgement judgement;
  judgement.quantity = "wrong pixels";
  judgement.verdict = Verdict::reproduced;
  double measured = 0;
  double stated = 0;
  for (const nlohmann::json& entry : rule.parameters.at("expected")) {
    const std::string backend = entry.value("backend", "");
    const std::string figure = entry.value("figure", "");
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const bench::Row& candidate) {
      return candidate.cell.task == "sign-map" && candidate.cell.backend == backend &&
             figure_of(candidate) == figure;
    });
    if (row == rows.end()) throw Incomplete("no sign map " + figure + " of backend " + backend);
    for (const char* kind : kinds) {
      const double published = entry.value(kind, 0.0);
      measured += counter(*row, kind);
      stated += published;
      if (counter(*row, kind) != published) judgement.verdict = Verdict::refuted;
    }
    judgement.lines.push_back(figure + ", " + backend + ": " + counts_text(*row) + "; stated " +
                              number_text(entry.value("false_zero", 0.0)) + ", " +
                              number_text(entry.value("inverted", 0.0)) + ", " +
                              number_text(entry.value("false_nonzero", 0.0)));
  }
  judgement.measured = measured;
  judgement.bound = stated;
  return judgement;
}

constexpr std::array<Parameter, 1> parameters{{{"expected", ParameterKind::tables, true}}};

}  // namespace

constinit const Judge sign_map_counts_judge{
    "sign-map-counts", "wrong signs on a grid of neighbouring doubles against the published numbers",
    parameters, judge};

}  // namespace tribunal::reports
