#include "bench/campaign.hpp"

#include "bench/cell.hpp"
#include "bench/estimate.hpp"
#include "bench/index.hpp"
#include "bench/interrupt.hpp"
#include "bench/manifest.hpp"
#include "bench/sandbox.hpp"
#include "bench/store.hpp"
#include "datasets/files/files.hpp"

#include <nlohmann/json.hpp>

#include <unordered_set>
#include <utility>

namespace tribunal::bench {
namespace {

using nlohmann::json;

std::string cell_work(const Cell& cell) {
  return json(run_cell(cell)).dump(-1, ' ', false, json::error_handler_t::replace);
}

/// The child's row, or a row that says how the child failed.
Row to_row(const Cell& cell, const Ending& ending) {
  Row row = blank_row(cell);
  row.outcome = to_string(ending.outcome);
  row.reason = ending.reason;
  if (ending.outcome != Outcome::ok) return row;
  try {
    return json::parse(ending.result).get<Row>();
  } catch (const json::exception& error) {  // e.g. a counter that is not a number, which JSON cannot say
    row.outcome = to_string(Outcome::crash);
    row.reason = std::string("the result is no row: ") + error.what();
    return row;
  }
}

bool is_failure(const Row& row) {
  return row.outcome != to_string(Outcome::ok) && row.outcome != to_string(Outcome::out_of_domain) &&
         row.outcome != to_string(Outcome::refused_input);
}

std::vector<const Cell*> cells_without_row(const Plan& plan, std::span<const Row> rows) {
  std::unordered_set<std::string> known;
  for (const Row& row : rows) known.insert(row.key);
  std::vector<const Cell*> pending;
  for (const Cell& cell : plan.cells)
    if (!known.contains(cell_key(cell))) pending.push_back(&cell);
  return pending;
}

struct Finished {
  Row row;
  double seconds;
};

/// The children at work and the cells they work on, index by index.
class Crew {
 public:
  explicit Crew(const Limits& limits) : limits_(limits) {}

  std::size_t size() const { return children_.size(); }
  std::span<const Child> children() const { return children_; }

  void start(const Cell& cell) {
    children_.emplace_back([&cell] { return cell_work(cell); }, limits_);
    cells_.push_back(&cell);
  }

  /// Lets go of the children that have ended; a row and its cost in seconds for each.
  std::vector<Finished> collect() {
    std::vector<Finished> finished;
    for (std::size_t i = 0; i < children_.size();) {
      if (!children_[i].advance()) {
        ++i;
        continue;
      }
      const Ending& ending = children_[i].ending();
      finished.push_back({to_row(*cells_[i], ending), ending.seconds});
      children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
      cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return finished;
  }

 private:
  Limits limits_;
  std::vector<Child> children_;
  std::vector<const Cell*> cells_;
};

/// Stores rows and tells the user how far it is.
class Ledger {
 public:
  Ledger(RunFolder& folder, const Plan& plan, std::span<const Cell* const> pending,
         const CampaignOptions& options)
      : folder_(folder), options_(options), estimate_(pending) {
    progress_.done = plan.cells.size() - pending.size();
    progress_.total = plan.cells.size();
    for (const Row& row : folder.rows()) progress_.failures += is_failure(row);
  }

  void store(std::span<const Finished> finished) {
    if (finished.empty()) return;
    std::vector<Row> rows;
    for (const Finished& f : finished) rows.push_back(f.row);
    folder_.append(rows);
    for (const Finished& f : finished) report(f);
  }

 private:
  void report(const Finished& finished) {
    estimate_.note(finished.row.cell, finished.seconds);
    ++progress_.done;
    progress_.failures += is_failure(finished.row);
    progress_.last = &finished.row;
    progress_.seconds_left = estimate_.seconds_left(options_.jobs);
    if (options_.progress) options_.progress(progress_);
  }

  RunFolder& folder_;
  const CampaignOptions& options_;
  Estimate estimate_;
  Progress progress_;
};

/// Works through the cells until all are done or the user wants to stop; true when it is the latter.
bool work(std::span<const Cell* const> pending, const Limits& limits, int jobs, Ledger& ledger) {
  Interrupt interrupt;
  Crew crew(limits);
  std::vector<Finished> finished;
  std::size_t next = 0;
  for (;;) {
    const bool stopping = interrupt.requested();
    while (!stopping && next < pending.size() && crew.size() < static_cast<std::size_t>(jobs))
      crew.start(*pending[next++]);
    ledger.store(finished);  // the disk is waited for while the children work
    if (stopping || crew.size() == 0) return next < pending.size() || crew.size() > 0;
    wait(crew.children(), interrupt.descriptor());
    finished = crew.collect();
  }
}

}  // namespace

CampaignResult run_campaign(const Plan& plan, const CampaignOptions& options) {
  if (options.jobs < 1 || options.jobs > 1024) throw BadInput("jobs is a whole number from 1 to 1024");
  RunFolder folder(options.folder, options.resume ? RunFolder::Mode::resume : RunFolder::Mode::fresh);
  update_manifest(options.folder, plan);
  const std::size_t held = folder.rows().size();
  const std::vector<const Cell*> pending = cells_without_row(plan, folder.rows());
  Ledger ledger(folder, plan, pending, options);

  CampaignResult result;
  result.interrupted = work(pending, plan.limits, options.jobs, ledger);
  result.rows = folder.rows();
  result.ran = result.rows.size() - held;
  for (const Row& row : result.rows) ++result.outcomes[row.outcome];
  result.digest = digest_run(result.rows);
  write_index(folder.path() / "index.sqlite", result.rows);
  return result;
}

}  // namespace tribunal::bench
