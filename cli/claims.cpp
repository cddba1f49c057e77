// tribunal claims: try what the literature states.
#include "bench/campaign.hpp"
#include "cli/progress.hpp"
#include "cli/scratch.hpp"
#include "cli/trials.hpp"
#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <ostream>
#include <set>

namespace tribunal::cli {
namespace {

std::vector<reports::Claim> chosen(const std::vector<std::string>& ids) {
  std::vector<reports::Claim> all = reports::registered_claims();
  if (ids.empty()) return all;
  std::vector<reports::Claim> some;
  for (const std::string& id : ids) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& claim) { return claim.id == id; });
    if (found == all.end()) throw BadUsage("there is no claim '" + id + "'; see tribunal list claims");
    some.push_back(*found);
  }
  return some;
}

bench::Plan plan_of(const std::vector<reports::Claim>& claims, std::string_view tier) {
  bench::Plan plan;
  plan.name = "claims-" + std::string(tier);
  plan.limits.seconds = 600;
  std::set<std::string> keys;
  for (const reports::Claim& claim : claims)
    for (const bench::Cell& cell : cells_of(claim, tier))
      if (keys.insert(bench::cell_key(cell)).second) plan.cells.push_back(cell);
  return plan;
}

}  // namespace

int claims(const ClaimsOptions& options, Console& console) {
  const auto tried = chosen(options.ids);
  std::optional<ScratchFolder> scratch;
  if (options.directory.empty()) scratch.emplace();
  const std::filesystem::path folder = scratch ? scratch->path() : std::filesystem::path(options.directory);
  const auto result =
      bench::run_campaign(plan_of(tried, options.tier), {.folder = folder,
                                                         .jobs = options.jobs,
                                                         .resume = options.resume,
                                                         .progress = progress_printer(console)});
  if (result.interrupted) {
    console.log << "interrupted; "
                << (scratch ? "with -o the rows would have been kept\n" : "--resume goes on\n");
    return judged_bad;
  }
  std::vector<reports::Tried> trials;
  trials.reserve(tried.size());
  const RowsByKey rows = by_key(result.rows);
  for (const reports::Claim& claim : tried) trials.push_back(try_on(claim, options.tier, rows));
  if (console.json)
    print_json(console, reports::claims_json(trials));
  else
    console.out << reports::verdict_table(trials) << (options.ids.empty() ? "" : reports::evidence(trials));
  const bool as_expected =
      std::all_of(trials.begin(), trials.end(), [](const auto& t) { return t.as_expected(); });
  return as_expected ? good : judged_bad;
}

}  // namespace tribunal::cli
