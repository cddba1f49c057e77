// tribunal report: one offline page from result rows.
#include "bench/store.hpp"
#include "cli/trials.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/text.hpp"
#include "reports/page/page.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <tuple>
#include <vector>

namespace tribunal::cli {
namespace {

nlohmann::json manifest_of(const std::string& directory) {
  const std::filesystem::path path = std::filesystem::path(directory) / "manifest.json";
  nlohmann::json manifest = nlohmann::json::parse(read_text(path), nullptr, false);
  if (!manifest.is_object()) throw BadInput(path.string() + ": not the manifest of a run");
  return manifest;
}

/// Rows come in the order in which cells ended, which no page should depend on.
void sort_by_cell(std::vector<bench::Row>& rows) {
  const auto place = [](const bench::Row& row) {
    const bench::Cell& c = row.cell;
    return std::tie(c.backend, c.task, c.dataset, c.order, c.n, c.bits, c.seed, c.order_seed, row.key);
  };
  std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
}

/// By the full tier where all its rows are there, else by the quick one.
reports::Tried try_by_best_tier(const reports::Claim& claim, const RowsByKey& rows) {
  reports::Tried tried = try_on(claim, "full", rows);
  return tried.judgement.verdict == reports::Verdict::untried ? try_on(claim, "quick", rows) : tried;
}

}  // namespace

int report(const ReportOptions& options, Console& console) {
  if (console.json && options.output == "-") throw BadUsage("--json and the page both want standard output");
  std::vector<bench::Row> rows = bench::read_rows(options.directories);
  nlohmann::json manifests = nlohmann::json::object();
  for (const std::string& directory : options.directories) manifests[directory] = manifest_of(directory);
  sort_by_cell(rows);
  const RowsByKey index = by_key(rows);
  std::vector<reports::Tried> trials;
  for (const reports::Claim& claim : reports::registered_claims())
    trials.push_back(try_by_best_tier(claim, index));

  const nlohmann::json manifest = manifests.size() == 1 ? *manifests.begin() : manifests;
  write_text(options.output, reports::page({.manifest = manifest, .rows = rows, .trials = trials}));
  if (console.json) {
    nlohmann::json document = reports::claims_json(trials);
    document["report"] = options.output;
    document["rows"] = rows.size();
    print_json(console, document);
  } else if (options.output != "-") {
    console.out << reports::verdict_table(trials) << "\n"
                << rows.size() << " rows in " << options.output << '\n';
  }
  return good;
}

}  // namespace tribunal::cli
