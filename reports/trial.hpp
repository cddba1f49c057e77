// From claims and rows to verdicts.
#pragma once

#include "reports/claim.hpp"
#include "reports/judges/judge.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace tribunal::reports {

/// A claim, what came of its trial, and the command that repeats it.
struct Tried {
  Claim claim;
  Judgement judgement;
  std::string command;

  /// Whether the verdict is the registered expectation. An untried claim surprises nobody.
  [[nodiscard]] bool as_expected() const {
    return judgement.verdict == claim.expected || judgement.verdict == Verdict::untried;
  }
};

/// Judges a claim by the rows of its own cells: the caller picks them out of a run by their keys. No rows:
/// untried.
Judgement try_claim(const Claim& claim, Rows rows);

/// The document of `tribunal claims --json`.
nlohmann::json claims_json(std::span<const Tried> trials);

/// What the family of claims amounts to, several trials at once being several chances to err.
struct Family {
  std::vector<double> adjusted;  ///< Holm-adjusted p-value per trial; NaN where the judge states none
  double expected_false_refutations = 0;  ///< were all tried claims true
};
Family family(std::span<const Tried> trials);

/// The verdicts as a plain-text table for a terminal, and one line that sums them up.
std::string verdict_table(std::span<const Tried> trials);

/// What each claim states, what was expected, and the figures that its verdict rests on, line by line.
std::string evidence(std::span<const Tried> trials);

}  // namespace tribunal::reports
