// Laws of cells: equal cells give equal rows, wrong results have no time, counters do not depend on being
// timed.
#include "bench/cell.hpp"

#include "algorithms/list.hpp"
#include "bench/digest.hpp"
#include "bench/experiments/experiment.hpp"
#include "bench/judge.hpp"
#include "datasets/files/files.hpp"
#include "tests/bench/support.hpp"

#include <algorithm>

namespace tribunal::bench {
namespace {

Cell cell_of(const char* task, const char* backend, const char* dataset, std::uint64_t n) {
  Cell cell;
  cell.task = task, cell.backend = backend, cell.dataset = dataset, cell.n = n;
  return cell;
}

TEST(Cells, GiveTheSameRowTwice) {
  for (const Cell& cell : small_plan().cells)
    EXPECT_EQ(digest_line(run_cell(cell)), digest_line(run_cell(cell)));
}

TEST(Cells, AnExactBackendSucceedsOnHardInput) {
  for (const PlanarAlgorithm& algorithm : planar_algorithms())
    for (const char* dataset : {"uniform", "grid", "circle", "collinear", "duplicates"}) {
      Cell cell = cell_of(algorithm.about.name.data(), "gmp", dataset, 50);
      if (algorithm.about.reads_values) cell.parameters = {{"data", "F1"}};
      const Row row = run_cell(cell);
      EXPECT_EQ(row.outcome, "ok") << row.command << ": " << row.reason;
      EXPECT_EQ(row.digest.size(), 16u);
    }
}

TEST(Cells, CountersOfATriangulationAddUp) {
  const Row row = run_cell(cell_of("green-sibson", "gmp", "uniform", 100));
  const auto at = [&](const char* name) { return row.counters.at(name); };
  const double sites = at("points") - at("duplicates");
  EXPECT_EQ(at("triangles"), 2 * sites - 2 - at("hull"));
  EXPECT_EQ(at("dimension"), 2);
  EXPECT_EQ(at("incircle"), at("incircle.exact"));
  EXPECT_EQ(at("orient2d"), at("orient2d.exact"));
  EXPECT_GT(at("history.nodes"), sites);
  EXPECT_EQ(row.counters.count("ties"), 1u);
  EXPECT_TRUE(row.seconds.empty());
}

TEST(Cells, TimedCellsHaveTheSameCountersWithoutThePredicates) {
  Cell cell = cell_of("bowyer", "gmp", "uniform", 60);
  std::map<std::string, double> counted = run_cell(cell).counters;
  std::erase_if(counted, [](const auto& entry) {
    return entry.first.rfind("orient2d", 0) == 0 || entry.first.rfind("incircle", 0) == 0;
  });
  cell.measure = Measure::time;
  cell.repeats = 4;
  const Row timed = run_cell(cell);
  EXPECT_EQ(timed.counters, counted);
  ASSERT_EQ(timed.seconds.size(), 4u);
  for (const double sample : timed.seconds) EXPECT_GT(sample, 0);
}

TEST(Cells, AWrongResultHasNoTime) {
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Cell cell = cell_of("green-sibson", "double", "near-collinear", 60);
    cell.seed = seed;
    cell.measure = Measure::time;
    const Row row = run_cell(cell);
    wrong += row.outcome != "ok";
    EXPECT_EQ(row.seconds.empty(), row.outcome != "ok") << row.outcome;
    EXPECT_EQ(row.reason.empty(), row.outcome == "ok");
  }
  EXPECT_GT(wrong, 0) << "the law was not tried";
}

TEST(Cells, RefusalNamesThePoint) {
  const Row row = run_cell(cell_of("bowyer", "knuth", "mixed-exponents", 50));
  EXPECT_EQ(row.outcome, "out_of_domain");
  EXPECT_EQ(row.reason.rfind("point ", 0), 0u) << row.reason;
}

TEST(Cells, QuantisedInputLiesOnTheLattice) {
  Cell cell = cell_of("bowyer", "knuth", "uniform", 200);
  cell.bits = 10;
  EXPECT_EQ(run_cell(cell).outcome, "ok");
}

TEST(Cells, ParametersReachTheAlgorithmAndTheReplay) {
  Cell cell = cell_of("green-sibson", "gmp", "uniform", 60);
  const Row by_history = run_cell(cell);
  cell.parameters = {{"location", "walk"}};
  const Row by_walk = run_cell(cell);
  EXPECT_EQ(by_walk.digest, by_history.digest);
  EXPECT_EQ(by_walk.counters.count("history.nodes"), 0u);
  EXPECT_NE(by_walk.key, by_history.key);
  EXPECT_NE(by_walk.command.find(R"("parameters":{"location":"walk"})"), std::string::npos)
      << by_walk.command;
  cell.parameters = {{"location", "taxi"}};
  EXPECT_THROW(run_cell(cell), BadInput);
  cell.parameters = {{"place", "walk"}};
  EXPECT_THROW(run_cell(cell), BadInput);
}

TEST(Cells, NamesThatDoNotExistAreBadInput) {
  EXPECT_THROW(run_cell(cell_of("boyer", "gmp", "uniform", 9)), BadInput);
  EXPECT_THROW(run_cell(cell_of("bowyer", "gimp", "uniform", 9)), BadInput);
  EXPECT_THROW(run_cell(cell_of("bowyer", "gmp", "unicorn", 9)), BadInput);
  EXPECT_THROW(run_cell(cell_of("bowyer", "gmp", "uniform", std::uint64_t{1} << 40)), BadInput);
  Cell cell = cell_of("bowyer", "gmp", "uniform", 9);
  cell.order = "sorted";
  EXPECT_THROW(run_cell(cell), BadInput);
  cell = cell_of("bowyer", "gmp", "uniform", 9);
  cell.bits = 54;
  EXPECT_THROW(run_cell(cell), BadInput);
}

TEST(Tasks, HaveOneName) {
  for (const Experiment& experiment : experiments())
    EXPECT_EQ(find_planar_algorithm(experiment.name), nullptr) << experiment.name;
}

/// The unit square with its centre: four triangles.
const std::vector<Point2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
Triangulation square_mesh() {
  Triangulation t;
  t.dimension = 2;
  t.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return t;
}

TEST(Judge, TellsWrongMeshesApart) {
  EXPECT_EQ(judge(square, square_mesh()).outcome, Outcome::ok);

  Triangulation missing = square_mesh();
  missing.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(judge(square, missing).outcome, Outcome::missing_site);

  Triangulation hole = square_mesh();
  hole.triangles.pop_back();
  EXPECT_EQ(judge(square, hole).outcome, Outcome::invalid_topology);

  const std::vector<Point2> kite{{0, 0}, {4, -1}, {8, 0}, {4, 1}};
  Triangulation wide = square_mesh();
  wide.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(judge(kite, wide).outcome, Outcome::non_delaunay);

  Triangulation flat;
  flat.dimension = 1;
  flat.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  EXPECT_NE(judge(square, flat).outcome, Outcome::ok);
}

TEST(Judge, APathMustBeWhole) {
  const std::vector<Point2> line{{0, 0}, {1, 1}, {2, 2}};
  Triangulation path;
  path.dimension = 1;
  path.edges = {{0, 1}, {1, 2}};
  EXPECT_EQ(judge(line, path).outcome, Outcome::ok);
  path.edges.pop_back();
  EXPECT_EQ(judge(line, path).outcome, Outcome::invalid_topology);
}

}  // namespace
}  // namespace tribunal::bench
