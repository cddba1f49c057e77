// Laws of the run folder: a row appended stays, a torn last line never counts, damage is named and nothing is
// lost.
#include "bench/store.hpp"

#include "bench/cell.hpp"
#include "bench/index.hpp"
#include "bench/manifest.hpp"
#include "datasets/files/files.hpp"
#include "tests/bench/support.hpp"

#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include <sys/wait.h>
#include <unistd.h>

namespace tribunal::bench {
namespace {

using Mode = RunFolder::Mode;
using nlohmann::json;

Row row_of(std::uint64_t seed, const char* outcome = "ok") {
  Cell cell;
  cell.task = "bowyer";
  cell.seed = seed;
  Row row = blank_row(cell);
  row.outcome = outcome;
  row.counters["tau"] = static_cast<double>(seed);
  row.seconds = {1, 2};
  return row;
}

/// A folder with rows of seeds 1 .. 3.
std::filesystem::path three_rows(const TemporaryFolder& folder) {
  RunFolder run(folder / "run", Mode::fresh);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) run.append(std::vector{row_of(seed)});
  return folder / "run" / "rows" / "local.jsonl";
}

std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Store, RowsComeBackAsTheyWent) {
  const TemporaryFolder folder;
  three_rows(folder);
  const std::vector<Row> rows = read_rows(folder / "run");
  ASSERT_EQ(rows.size(), 3u);
  for (std::uint64_t i = 0; i < 3; ++i) EXPECT_EQ(json(rows[i]), json(row_of(i + 1)));
}

TEST(Store, ABatchOfRowsIsALineEach) {
  const TemporaryFolder folder;
  const std::string one_by_one = read_file(three_rows(folder));
  RunFolder run(folder / "batch", Mode::fresh);
  run.append(std::vector{row_of(1), row_of(2), row_of(3)});
  EXPECT_EQ(read_file((folder / "batch") / "rows" / "local.jsonl"), one_by_one);
  EXPECT_EQ(run.rows().size(), 3u);
}

TEST(Store, LastLineTornAnywhereIsDroppedAndCutOff) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  const std::string whole = read_file(file);
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t cut = last; cut < whole.size(); ++cut) {
    write_file(file, whole.substr(0, cut));
    EXPECT_EQ(read_rows(folder / "run").size(), 2u) << cut;
    EXPECT_EQ(read_file(file).size(), cut) << "reading changes nothing";
    if (cut % 16 != 0) continue;
    RunFolder run(folder / "run", Mode::resume);
    EXPECT_EQ(run.rows().size(), 2u);
    run.append(std::vector{row_of(3)});
    ASSERT_EQ(read_file(file), whole) << cut;
  }
}

TEST(Store, AFileThatIsOneTornLineHoldsNothing) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  write_file(file, "{\"schema\":1,");
  RunFolder run(folder / "run", Mode::resume);
  EXPECT_TRUE(run.rows().empty());
  EXPECT_EQ(read_file(file), "");
}

TEST(Store, DamagedLineIsNamedAndNothingIsLost) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  std::string text = read_file(file);
  text[text.find('\n') + 1] = '#';
  write_file(file, text);
  for (const Mode mode : {Mode::fresh, Mode::resume}) {
    const std::string message = complaint([&] { RunFolder(folder / "run", mode); });
    EXPECT_EQ(message.rfind(file.string() + ":2: ", 0), 0u) << message;
  }
  EXPECT_EQ(read_file(file), text);
}

TEST(Store, EmptyLineIsDamage) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  write_file(file, read_file(file) + "\n");
  EXPECT_EQ(complaint([&] { read_rows(folder / "run"); }).rfind(file.string() + ":4: ", 0), 0u);
}

TEST(Store, KeyMustMatchTheCell) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  std::string text = read_file(file);
  const std::string key = row_of(2).key;
  text.replace(text.find(key), key.size(), row_of(9).key);
  write_file(file, text);
  EXPECT_EQ(complaint([&] { read_rows(folder / "run"); }),
            file.string() + ":2: the key does not match the cell");
}

TEST(Store, DoublesCountOnceAndContradictionsAreNamed) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  const std::string whole = read_file(file);
  const auto with = [&](const Row& row) { write_file(file, whole + json(row).dump() + '\n'); };
  Row again = row_of(2);
  again.seconds = {7};
  with(again);
  EXPECT_EQ(read_rows(folder / "run").size(), 3u);
  with(row_of(2, "timeout"));
  EXPECT_EQ(read_rows(folder / "run")[1].outcome, "ok");
  with(row_of(2, "crash"));
  EXPECT_EQ(complaint([&] { read_rows(folder / "run"); }),
            file.string() + ":4: another row of the same cell differs from this one");
  write_file(file, json(row_of(2, "timeout")).dump() + '\n' + json(row_of(2)).dump() + '\n');
  ASSERT_EQ(read_rows(folder / "run").size(), 1u);
  EXPECT_EQ(read_rows(folder / "run")[0].outcome, "ok");
}

TEST(Store, FreshRunNeverTouchesAFolderWithRows) {
  const TemporaryFolder folder;
  const auto file = three_rows(folder);
  const std::string whole = read_file(file);
  EXPECT_EQ(complaint([&] { RunFolder(folder / "run", Mode::fresh); }),
            (folder / "run").string() + ": holds 3 rows already; --resume continues such a run");
  EXPECT_EQ(read_file(file), whole);
}

TEST(Store, ResumingWhatIsNotThereStartsIt) {
  const TemporaryFolder folder;
  EXPECT_TRUE(RunFolder(folder / "run", Mode::resume).rows().empty());
}

TEST(Store, AFileIsNoRunFolder) {
  const TemporaryFolder folder;
  write_file(folder / "run", "");
  EXPECT_NE(complaint([&] { RunFolder(folder / "run", Mode::fresh); }), "no complaint");
  EXPECT_NE(complaint([&] { read_rows(folder / "run"); }), "no complaint");
  EXPECT_NE(complaint([&] { read_rows(folder / "none"); }), "no complaint");
}

TEST(Store, OneProcessAtATime) {
  const TemporaryFolder folder;
  const RunFolder held(folder / "run", Mode::fresh);
  const pid_t other = fork();
  if (other == 0) {
    const std::string message = complaint([&] { RunFolder(folder / "run", Mode::resume); });
    _exit(message == (folder / "run").string() + ": another run is writing into this folder" ? 0 : 1);
  }
  int status = 0;
  waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(Store, ReleasedFolderCanBeHeldAgain) {
  const TemporaryFolder folder;
  { const RunFolder held(folder / "run", Mode::fresh); }
  EXPECT_NO_THROW(RunFolder(folder / "run", Mode::fresh));
}

double query(const std::filesystem::path& path, const char* statement) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  sqlite3_stmt* prepared = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(database, statement, -1, &prepared, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  EXPECT_EQ(sqlite3_step(prepared), SQLITE_ROW);
  const double value = sqlite3_column_double(prepared, 0);
  sqlite3_finalize(prepared);
  sqlite3_close(database);
  return value;
}

TEST(Index, HoldsWhatTheRowsHold) {
  const TemporaryFolder folder;
  const auto path = folder / "index.sqlite";
  std::vector<Row> rows;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) rows.push_back(row_of(seed));
  rows[3].texts["it's"] = "Robert'); DROP TABLE cells;--";
  for (int rebuild = 0; rebuild < 2; ++rebuild) {
    write_index(path, rows);
    EXPECT_EQ(query(path, "SELECT count(*) FROM cells"), 10);
    EXPECT_EQ(query(path, "SELECT count(*) FROM seconds"), 20);
    EXPECT_EQ(query(path, "SELECT sum(value) FROM counters WHERE name = 'tau'"), 55);
    EXPECT_EQ(query(path, "SELECT count(*) FROM texts"), 1);
    EXPECT_EQ(query(path, "SELECT sum(seed) FROM cells WHERE outcome = 'ok' AND \"order\" = 'random'"), 55);
  }
}

TEST(Manifest, NamesBuildMachineAndInputs) {
  const json manifest = make_manifest(small_plan());
  for (const char* part : {"schema", "build", "floating_point", "libraries", "machine", "plans"})
    EXPECT_TRUE(manifest.contains(part)) << part;
  EXPECT_EQ(manifest["plans"][0]["seeds"], json({"1..3"}));
  EXPECT_EQ(manifest["plans"][0]["cells"], small_plan().cells.size());
}

TEST(Manifest, RowsOfAnotherBuildAreNotMixedIn) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "run");
  const auto path = folder / "run" / "manifest.json";
  update_manifest(folder / "run", small_plan());
  update_manifest(folder / "run", small_plan());
  json manifest = json::parse(read_file(path));
  EXPECT_EQ(manifest["plans"].size(), 1u);
  manifest["build"]["commit"] = "0000000000000000000000000000000000000000";
  write_file(path, manifest.dump());
  EXPECT_NE(complaint([&] { update_manifest(folder / "run", small_plan()); }).find("another build"),
            std::string::npos);
  write_file(path, "{");
  EXPECT_EQ(complaint([&] { update_manifest(folder / "run", small_plan()); }).rfind(path.string(), 0), 0u);
}

}  // namespace
}  // namespace tribunal::bench
