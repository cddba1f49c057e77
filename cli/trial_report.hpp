// What `tribunal try` prints and draws.
#pragma once

#include "bench/outsider/finding.hpp"
#include "cli/console.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace tribunal::cli {

struct TrialReport {
  std::string name, cites, summary;  ///< of the outsider
  bench::TrialResult result;
  bool interrupted = false;  ///< by the user: the result is what there was by then
};

/// True when all was tried, nothing failed and something was right: an outsider that refuses everything has
/// shown nothing.
bool is_clean(const TrialReport& report);

/// As JSON, or a table for each kind of task, then the counterexamples with their replays.
void print_trial(const TrialReport& report, Console& console);

/// One .svg in the folder, which is made when missing, for each counterexample in the plane. Throws BadInput.
void draw_counterexamples(const std::filesystem::path& folder,
                          std::span<const bench::Counterexample> counterexamples);

}  // namespace tribunal::cli
