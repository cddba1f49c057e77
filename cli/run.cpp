// tribunal run: a campaign on this machine.
#include "bench/campaign.hpp"
#include "cli/progress.hpp"
#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

#include <ostream>

namespace tribunal::cli {

int run(const RunOptions& options, Console& console) {
  const bench::Plan plan = bench::parse_plan(options.plan);
  const bench::CampaignResult result = bench::run_campaign(plan, {.folder = options.directory,
                                                                  .jobs = options.jobs,
                                                                  .resume = options.resume,
                                                                  .progress = progress_printer(console)});
  if (console.json) {
    print_json(console, {{"name", plan.name},
                         {"directory", options.directory},
                         {"cells", plan.cells.size()},
                         {"ran", result.ran},
                         {"outcomes", result.outcomes},
                         {"digest", result.digest.digest},
                         {"not_digested", result.digest.excluded},
                         {"interrupted", result.interrupted}});
  } else {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [outcome, count] : result.outcomes) rows.push_back({outcome, std::to_string(count)});
    rows.push_back({"digest", result.digest.digest});
    rows.push_back({"rows", options.directory});
    print_table(console, rows);
    if (result.interrupted) console.log << "interrupted; --resume goes on\n";
  }
  return result.interrupted ? judged_bad : good;
}

}  // namespace tribunal::cli
