// Laws of cells and rows: JSON gives back what went in, keys tell cells apart, commands repeat them.
#include "bench/cell.hpp"
#include "bench/digest.hpp"
#include "tests/bench/support.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <set>

namespace tribunal::bench {
namespace {

using nlohmann::json;

Cell strange_cell() {
  Cell cell;
  cell.task = "it's \"strange\"\\n$(HOME) `x`";
  cell.backend = "\xc3\xa4";
  cell.n = 18446744073709551615u;
  cell.seed = 9223372036854775808u;
  cell.bits = 53;
  cell.measure = Measure::time;
  cell.parameters = {{"a", "b'c"}, {"", ""}};
  return cell;
}

TEST(RowJson, GivesBackTheSameRow) {
  Row row = blank_row(strange_cell());
  row.outcome = "crash";
  row.reason = "a\nb";
  row.counters = {{"tau", 1e300}, {"x", 0.1}, {"tiny", 4.9406564584124654e-324}};
  row.texts = {{"signs", "+[3]"}};
  row.seconds = {0.25, 1e-9};
  row.peak_bytes = 1234567890123;
  row.digest = "0123456789abcdef";
  const json once = row;
  EXPECT_EQ(json(json::parse(once.dump()).get<Row>()), once);
}

TEST(RowJson, AnotherSchemaIsRefused) {
  json row = blank_row(strange_cell());
  row["schema"] = row_schema + 1;
  EXPECT_THROW(row.get<Row>(), json::exception);
}

TEST(CellJson, OnlyTheTaskIsNeeded) {
  EXPECT_EQ(json::parse(R"({"task":"bowyer"})").get<Cell>().order, "random");
  EXPECT_THROW(json::parse("{}").get<Cell>(), json::exception);
  EXPECT_THROW(json::parse("[]").get<Cell>(), json::exception);
  EXPECT_THROW(json::parse(R"({"task":"bowyer","measure":"speed"})").get<Cell>(), json::exception);
}

TEST(CellKey, DependsOnEveryField) {
  std::set<std::string> keys{cell_key(Cell{})};
  const json plain = Cell{};
  for (const auto& [name, value] : plain.items()) {
    json changed = plain;
    if (name == "measure")
      changed[name] = "time";
    else if (value.is_string())
      changed[name] = "other";
    else if (value.is_object())
      changed[name] = {{"a", "b"}};
    else
      changed[name] = value.get<int>() + 7;
    EXPECT_TRUE(keys.insert(cell_key(changed.get<Cell>())).second) << name;
  }
  EXPECT_EQ(keys.size(), plain.size() + 1);
}

// Recorded: a key is stable between builds and machines, or resuming and comparing runs would fail silently.
TEST(CellKey, IsStable) { EXPECT_EQ(cell_key(Cell{}), "a2319a618804117d"); }

TEST(Command, PassesAShellUnharmed) {
  const std::string command = repeat_command(strange_cell());
  const std::string prefix = "tribunal cell ";
  ASSERT_EQ(command.rfind(prefix, 0), 0u);
  FILE* shell = popen(("printf %s " + command.substr(prefix.size())).c_str(), "r");
  std::string text;
  for (int c = fgetc(shell); c != EOF; c = fgetc(shell)) text += static_cast<char>(c);
  pclose(shell);
  EXPECT_EQ(json::parse(text), json(strange_cell()));
}

Row row_with(std::uint64_t seed, const char* outcome) {
  Cell cell;
  cell.seed = seed;
  Row row = blank_row(cell);
  row.outcome = outcome;
  return row;
}

TEST(RunDigest, IgnoresOrderTimesAndMemory) {
  std::vector<Row> rows{row_with(1, "ok"), row_with(2, "crash"), row_with(3, "ok")};
  const std::string digest = digest_run(rows).digest;
  std::swap(rows[0], rows[2]);
  rows[0].seconds = {1, 2};
  rows[1].peak_bytes = 7;
  rows[1].reason = "signal";
  EXPECT_EQ(digest_run(rows).digest, digest);
}

TEST(RunDigest, SeesOutcomesCountersTextsAndMeshes) {
  const std::vector<Row> rows{row_with(1, "ok"), row_with(2, "ok")};
  std::set<std::string> digests{digest_run(rows).digest};
  const auto differs = [&](auto change) {
    std::vector<Row> changed = rows;
    change(changed[1]);
    return digests.insert(digest_run(changed).digest).second;
  };
  EXPECT_TRUE(differs([](Row& row) { row.outcome = "loop"; }));
  EXPECT_TRUE(differs([](Row& row) { row.counters["tau"] = 1; }));
  EXPECT_TRUE(differs([](Row& row) { row.counters["tau"] = std::nextafter(1.0, 2.0); }));
  EXPECT_TRUE(differs([](Row& row) { row.texts["signs"] = "+"; }));
  EXPECT_TRUE(differs([](Row& row) { row.digest = "1"; }));
  EXPECT_TRUE(digests.insert(digest_run(std::span(rows).first(1)).digest).second);
}

TEST(RunDigest, ListsWhatDependsOnTheMachine) {
  const std::vector<Row> rows{row_with(1, "ok"), row_with(2, "timeout"), row_with(3, "out_of_memory")};
  const RunDigest digest = digest_run(rows);
  EXPECT_EQ(digest.rows, 1u);
  EXPECT_EQ(digest.excluded.size(), 2u);
  EXPECT_EQ(digest.digest, digest_run(std::span(rows).first(1)).digest);
}

}  // namespace
}  // namespace tribunal::bench
