// Laws of campaigns: the rows do not depend on jobs, interruptions or crashes of the campaign itself.
#include "bench/campaign.hpp"

#include "bench/cell.hpp"
#include "bench/estimate.hpp"
#include "bench/store.hpp"
#include "datasets/files/files.hpp"
#include "datasets/random.hpp"
#include "tests/bench/support.hpp"

#include <sqlite3.h>

#include <cerrno>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tribunal::bench {
namespace {

TEST(Campaign, HasOneRowPerCellAndSaysWhatCameOfThem) {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  std::size_t reports = 0;
  const CampaignResult result =
      run_campaign(plan, {.folder = folder / "run", .progress = [&](const Progress& progress) {
                            EXPECT_EQ(progress.done, ++reports);
                            EXPECT_EQ(progress.total, plan.cells.size());
                            EXPECT_TRUE(progress.seconds_left.has_value());
                          }});
  EXPECT_EQ(reports, plan.cells.size());
  EXPECT_EQ(result.rows.size(), plan.cells.size());
  EXPECT_EQ(result.ran, plan.cells.size());
  EXPECT_FALSE(result.interrupted);
  std::size_t outcomes = 0;
  for (const auto& [name, count] : result.outcomes) outcomes += count;
  EXPECT_EQ(outcomes, plan.cells.size());
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "index.sqlite"));
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "manifest.json"));
}

TEST(Campaign, DigestDoesNotDependOnJobs) {
  const TemporaryFolder folder;
  const CampaignResult one = run_campaign(small_plan(), {.folder = folder / "one", .jobs = 1});
  const CampaignResult four = run_campaign(small_plan(), {.folder = folder / "four", .jobs = 4});
  EXPECT_EQ(one.digest.rows, small_plan().cells.size());
  EXPECT_EQ(one.digest.digest, four.digest.digest);
}

TEST(Campaign, SandboxedRowsAreThoseOfTheCells) {
  const TemporaryFolder folder;
  std::vector<Row> rows;
  for (const Cell& cell : small_plan().cells) rows.push_back(run_cell(cell));
  EXPECT_EQ(run_campaign(small_plan(), {.folder = folder / "run"}).digest.digest, digest_run(rows).digest);
}

TEST(Campaign, ResumeRunsOnlyWhatIsMissing) {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  Plan half = plan;
  half.cells.resize(plan.cells.size() / 2);
  run_campaign(half, {.folder = folder / "run"});
  EXPECT_THROW(run_campaign(plan, {.folder = folder / "run"}), BadInput);
  const CampaignResult rest = run_campaign(plan, {.folder = folder / "run", .resume = true});
  EXPECT_EQ(rest.ran, plan.cells.size() - half.cells.size());
  const CampaignResult nothing = run_campaign(plan, {.folder = folder / "run", .resume = true});
  EXPECT_EQ(nothing.ran, 0u);
  EXPECT_EQ(nothing.digest.digest, run_campaign(plan, {.folder = folder / "whole"}).digest.digest);
}

TEST(Campaign, FailuresAreRows) {
  const TemporaryFolder folder;
  Plan plan = small_plan();
  Plan hopeless;
  hopeless.limits = {.seconds = 0.05};
  Cell cell = plan_of("[[cells]]\nalgorithm='watson'\nbackend='gmp'\ndataset='uniform'\nn=200000\n").cells[0];
  hopeless.cells = {cell};
  cell.task = "no such task";
  hopeless.cells.push_back(cell);
  const CampaignResult result = run_campaign(hopeless, {.folder = folder / "run", .jobs = 2});
  EXPECT_EQ(result.outcomes.at("timeout"), 1u);
  EXPECT_EQ(result.outcomes.at("crash"), 1u);
  EXPECT_EQ(result.digest.excluded.size(), 1u);
}

TEST(Campaign, JobsAreChecked) {
  const TemporaryFolder folder;
  EXPECT_THROW(run_campaign(small_plan(), {.folder = folder / "run", .jobs = 0}), BadInput);
  EXPECT_THROW(run_campaign(small_plan(), {.folder = folder / "run", .jobs = 100000}), BadInput);
}

/// A process that runs the small plan, writing one byte for each row stored.
struct Driver {
  pid_t pid;
  int reports;

  Driver(const std::filesystem::path& folder, int jobs) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("pipe");
    pid = fork();
    if (pid == 0) {
      close(ends[0]);
      const auto report = [&](const Progress&) { static_cast<void>(!write(ends[1], "r", 1)); };
      const CampaignResult result =
          run_campaign(small_plan(), {.folder = folder, .jobs = jobs, .resume = true, .progress = report});
      const bool orphans = waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD;
      _exit(orphans ? 2 : result.interrupted ? 1 : 0);
    }
    close(ends[1]);
    reports = ends[0];
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// Returns once so many rows are stored, or the driver is done.
  void await(std::uint64_t rows) const {
    char byte = 0;
    while (rows > 0 && read(reports, &byte, 1) == 1) --rows;
  }

  /// Sends the signal and returns the driver's wait status.
  int end(int signal) const {
    kill(pid, signal);
    int status = 0;
    waitpid(pid, &status, 0);
    close(reports);
    return status;
  }
};

TEST(Campaign, KilledAtAnyMomentAndResumedGivesTheSameDigest) {
  const TemporaryFolder folder;
  const std::string expected = run_campaign(small_plan(), {.folder = folder / "whole"}).digest.digest;
  const std::size_t cells = small_plan().cells.size();
  Random random(1);
  std::size_t killed_midway = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const std::filesystem::path run = folder / ("killed" + std::to_string(trial)).c_str();
    const Driver driver(run, trial % 3 + 1);
    driver.await(random.below(cells));
    const timespec moment{0, static_cast<long>(random.below(5'000'000))};
    ppoll(nullptr, 0, &moment, nullptr);  // anywhere within a cell or a write: the law holds at every moment
    driver.end(SIGKILL);
    const CampaignResult resumed = run_campaign(small_plan(), {.folder = run, .resume = true});
    killed_midway += resumed.ran > 0 && resumed.ran < cells;
    EXPECT_EQ(resumed.digest.digest, expected) << trial;
    EXPECT_EQ(resumed.rows.size(), cells);
  }
  EXPECT_GT(killed_midway, 5u) << "the law was hardly tried";
}

TEST(Campaign, KilledAgainAndAgainEndsAllTheSame) {
  const TemporaryFolder folder;
  const std::string expected = run_campaign(small_plan(), {.folder = folder / "whole"}).digest.digest;
  for (int life = 0; life < 8; ++life) {
    const Driver driver(folder / "run", 2);
    driver.await(3);
    driver.end(SIGKILL);
  }
  EXPECT_EQ(run_campaign(small_plan(), {.folder = folder / "run", .resume = true}).digest.digest, expected);
}

TEST(Campaign, AskedToStopItKeepsItsRowsAndLeavesNoChild) {
  const TemporaryFolder folder;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Driver driver(folder / "run", 2);
    driver.await(2);
    const int status = driver.end(signal);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1) << "1: interrupted, no child left";
  }
  const std::size_t rows = read_rows(folder / "run").size();
  EXPECT_GE(rows, 6u);
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "index.sqlite"));
  const CampaignResult rest = run_campaign(small_plan(), {.folder = folder / "run", .resume = true});
  EXPECT_EQ(rest.ran, small_plan().cells.size() - rows);
}

Cell cell_of_size(std::uint64_t n, const char* task = "bowyer") {
  Cell cell;
  cell.task = task;
  cell.n = n;
  return cell;
}

TEST(Estimate, SaysNothingBeforeThereIsACost) {
  const Cell a = cell_of_size(100);
  const Cell* cells[] = {&a};
  EXPECT_FALSE(Estimate(cells).seconds_left(1).has_value());
}

TEST(Estimate, IsExactWhereCostIsProportional) {
  const Cell a = cell_of_size(100), b = cell_of_size(300), c = cell_of_size(200, "watson"),
             d = cell_of_size(400, "watson");
  const Cell* cells[] = {&a, &b, &c, &d};
  Estimate estimate(cells);
  estimate.note(a, 1);
  EXPECT_DOUBLE_EQ(*estimate.seconds_left(1), 3 + 2 + 4);
  estimate.note(c, 20);
  EXPECT_DOUBLE_EQ(*estimate.seconds_left(1), 3 + 40);
  EXPECT_DOUBLE_EQ(*estimate.seconds_left(2), (3 + 40) / 2.0);
  estimate.note(b, 3);
  estimate.note(d, 40);
  EXPECT_DOUBLE_EQ(*estimate.seconds_left(1), 0);
}

}  // namespace
}  // namespace tribunal::bench
