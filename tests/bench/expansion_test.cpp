// Laws of expansion: cells are the product of the keys' values, in a stated order, each once.
#include "algorithms/list.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"
#include "tests/bench/support.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace tribunal::bench {
namespace {

TEST(Expansion, DefaultsAreThoseOfTheCell) {
  const Plan plan = plan_of("[[cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='grid'\nn=9\n");
  ASSERT_EQ(plan.cells.size(), 1u);
  Cell expected;
  expected.task = "bowyer", expected.backend = "gmp", expected.dataset = "grid", expected.n = 9;
  EXPECT_EQ(nlohmann::json(plan.cells[0]), nlohmann::json(expected));
  EXPECT_EQ(plan.name, "test");
}

TEST(Expansion, EveryKeyMultiplies) {
  const Plan plan = plan_of(R"(
    [[cells]]
    algorithm = ["bowyer", "watson"]
    backend = ["double", "gmp"]
    dataset = ["grid", "uniform"]
    n = [10, 20]
    bits = [0, 10]
    seed = ["1..3", 9]
    order_seed = [1, 2]
    order = ["random", "x"]
    measure = ["counts", "time"]
    repeats = 2
  )");
  EXPECT_EQ(plan.cells.size(), 2u * 2 * 2 * 2 * 2 * 4 * 2 * 2 * 2);
}

TEST(Expansion, WhatIsComparedRunsSideBySide) {
  const Plan plan = plan_of(
      "[[cells]]\nalgorithm=['bowyer','watson']\nbackend=['gmp','double']\ndataset='grid'\nn=[20,10]\nseed='"
      "1..2'\n");
  std::vector<std::string> seen;
  for (const Cell& c : plan.cells)
    seen.push_back(c.task + ' ' + c.backend + ' ' + std::to_string(c.n) + ' ' + std::to_string(c.seed));
  const std::vector<std::string> expected{
      "bowyer gmp 20 1", "bowyer double 20 1", "watson gmp 20 1", "watson double 20 1",
      "bowyer gmp 20 2", "bowyer double 20 2", "watson gmp 20 2", "watson double 20 2",
      "bowyer gmp 10 1", "bowyer double 10 1", "watson gmp 10 1", "watson double 10 1",
      "bowyer gmp 10 2", "bowyer double 10 2", "watson gmp 10 2", "watson double 10 2"};
  EXPECT_EQ(seen, expected);
}

TEST(Expansion, OrderSeedFollowsTheSeedUnlessGiven) {
  for (const Cell& cell :
       plan_of("[[cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='grid'\nn=9\nseed='3..7'\n").cells)
    EXPECT_EQ(cell.order_seed, cell.seed);
  const Plan fixed = plan_of(
      "[[cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='grid'\nn=9\nseed='3..7'\norder_seed=1\n");
  ASSERT_EQ(fixed.cells.size(), 5u);
  for (const Cell& cell : fixed.cells) EXPECT_EQ(cell.order_seed, 1u);
}

TEST(Expansion, StarIsAllThatIsListed) {
  const Plan plan = plan_of("[[cells]]\nalgorithm='*'\nbackend='*'\ndataset='*'\nn=9\n");
  // But for algorithms that need data, which datasets have none of.
  std::size_t algorithms = 0;
  for (const PlanarAlgorithm& algorithm : planar_algorithms()) algorithms += !algorithm.about.reads_values;
  EXPECT_LT(algorithms, planar_algorithms().size());
  EXPECT_EQ(plan.cells.size(), algorithms * backends().size() * datasets().size());
}

TEST(Expansion, ExactBackendsHaveAWordWithAndWithoutTiesBroken) {
  const Plan plan =
      plan_of("[[cells]]\nalgorithm='bowyer'\nbackend=['exact','exact+sos']\ndataset='grid'\nn=9\n");
  std::set<std::string> expected, found;
  for (const BackendEntry& backend : backends())
    if (backend.about->exact)
      for (const char* suffix : {"", "+sos"}) expected.insert(std::string(backend.about->name) + suffix);
  for (const Cell& cell : plan.cells) found.insert(cell.backend);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(plan_of("[[cells]]\nalgorithm='bowyer'\nbackend='gmp+sos'\ndataset='grid'\nn=9\n").cells.size(),
            1u);
}

TEST(Expansion, NoTwoCellsShareAKey) {
  const Plan plan = plan_of(R"(
    [[cells]]
    algorithm = ["bowyer", "bowyer"]
    backend = "*"
    dataset = "*"
    n = [10, 20]
    seed = ["1..3", "2..4"]
    [[cells]]
    algorithm = "bowyer"
    backend = "gmp"
    dataset = "grid"
    n = 10
  )");
  std::set<std::string> keys;
  for (const Cell& cell : plan.cells) EXPECT_TRUE(keys.insert(cell_key(cell)).second);
}

TEST(Expansion, DatasetOfFixedSizeNeedsNoNAndHasNoMorePoints) {
  for (const Dataset& dataset : datasets()) {
    if (dataset.about.fixed_size == 0) continue;
    const std::string block =
        "[[cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='" + std::string(dataset.about.name) + "'\n";
    const Plan without = plan_of(block), with = plan_of(block + "n=[5,1000000,2000000]\n");
    ASSERT_EQ(without.cells.size(), 1u);
    ASSERT_EQ(with.cells.size(), 2u);
    EXPECT_EQ(without.cells[0].n, dataset.about.fixed_size);
    EXPECT_EQ(with.cells[0].n, 5u);
    EXPECT_EQ(cell_key(with.cells[1]), cell_key(without.cells[0]));
  }
}

TEST(Expansion, RepeatsMakeNoDifferenceToCounts) {
  const std::string block = "[[cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='grid'\nn=9\nrepeats=";
  EXPECT_EQ(cell_key(plan_of(block + "3\n").cells[0]), cell_key(plan_of(block + "4\n").cells[0]));
  const std::string timed = "\nmeasure='time'\n";
  EXPECT_NE(cell_key(plan_of(block + "3" + timed).cells[0]), cell_key(plan_of(block + "4" + timed).cells[0]));
}

TEST(Expansion, ParametersMultiplyAndDefaultsAreFilledIn) {
  const std::string block = "[[cells]]\nexperiment='sign-differential'\nbackend='gmp'\nn=9\n";
  const Plan plain = plan_of(block);
  ASSERT_EQ(plain.cells.size(), 1u);
  EXPECT_EQ(plain.cells[0].parameters.at("predicate"), "orient2d");
  const Plan spelled = plan_of(block + "parameters={predicate='orient2d',generator='uniform'}\n");
  EXPECT_EQ(cell_key(plain.cells[0]), cell_key(spelled.cells[0]));
  EXPECT_EQ(plan_of(block + "parameters={predicate=['orient2d','incircle'],generator=['grid','uniform']}\n")
                .cells.size(),
            4u);
}

// An algorithm's cell carries what is not standard, so that the plain algorithm keeps the key that it had
// before it had parameters.
TEST(Expansion, AnAlgorithmsDefaultsAreLeftOut) {
  const std::string block = "[[cells]]\nalgorithm='green-sibson'\nbackend='gmp'\ndataset='grid'\nn=9\n";
  const Plan plain = plan_of(block), spelled = plan_of(block + "parameters={location='history'}\n");
  EXPECT_TRUE(plain.cells[0].parameters.empty());
  EXPECT_EQ(cell_key(plain.cells[0]), "a8f24536a8bdc306");
  EXPECT_EQ(cell_key(spelled.cells[0]), cell_key(plain.cells[0]));
  const Plan both = plan_of(block + "parameters={location=['walk','history']}\n");
  ASSERT_EQ(both.cells.size(), 2u);
  EXPECT_EQ(both.cells[0].parameters.at("location"), "walk");
  EXPECT_NE(cell_key(both.cells[0]), cell_key(both.cells[1]));
}

TEST(Expansion, AClaimsTableMayHoldMoreThanCells) {
  const toml::table claim =
      toml::parse("rule='x'\n[[tier.cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='grid'\nn=9\n");
  EXPECT_EQ(expand(*claim["tier"].as_table(), "claim.toml").size(), 1u);
}

TEST(Expansion, LimitsAreRead) {
  const Plan plan = plan_of(
      "name='hard'\n[limits]\nseconds=1.5\nmemory_mib=100\n"
      "[[cells]]\nalgorithm='bowyer'\nbackend='gmp'\ndataset='grid'\nn=9\n");
  EXPECT_EQ(plan.name, "hard");
  EXPECT_EQ(plan.limits.seconds, 1.5);
  EXPECT_EQ(plan.limits.memory_mib, 100u);
}

}  // namespace
}  // namespace tribunal::bench
