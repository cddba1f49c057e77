// The driver of a campaign: every cell of a plan in a child of its own, every row in the folder.
#pragma once

#include "bench/digest.hpp"
#include "bench/plan.hpp"
#include "bench/row.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tribunal::bench {

/// How far a campaign is. Rows found on resuming count as done.
struct Progress {
  std::size_t done = 0;
  std::size_t total = 0;
  std::size_t failures = 0;                 ///< outcomes other than ok, out_of_domain and refused_input
  std::optional<double> seconds_left = {};  ///< nothing before there is a cost to go by
  const Row* last = nullptr;                ///< the row that has just been stored
};

struct CampaignOptions {
  std::filesystem::path folder;
  int jobs = 1;         ///< children at once, 1 to 1024
  bool resume = false;  ///< run only what the folder lacks
  std::function<void(const Progress&)> progress = {};
};

struct CampaignResult {
  std::vector<Row> rows;  ///< all rows of the folder, also those of an earlier plan
  std::size_t ran = 0;    ///< of these, by this call
  std::map<std::string, std::size_t> outcomes = {};  ///< of all rows, by name
  RunDigest digest = {};                             ///< of all rows
  bool interrupted = false;  ///< by SIGINT, SIGTERM or SIGHUP: some cells have no row yet
};

/// Runs the cells of the plan that have no row in the folder, each in a sandbox under the plan's limits,
/// `jobs` at once, started in plan order. A row is on the disk before it is reported; at the end
/// `index.sqlite` is rebuilt, also after an interruption (which kills the children and keeps every row).
/// Failing cells are data: the call succeeds. A row that timed out under other limits stands; to try it
/// again, use a new folder.
///
/// A row's `command` repeats its cell: `tribunal cell '<cell as JSON>'` prints the row that the cell gives,
/// unsandboxed.
///
/// Throws BadInput: a folder in use, one that holds rows without `resume`, or rows of another build; a
/// damaged row file. Throws std::system_error when a row cannot be stored or no process can be had; nothing
/// stored is lost.
CampaignResult run_campaign(const Plan& plan, const CampaignOptions& options);

}  // namespace tribunal::bench
