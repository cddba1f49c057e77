// Point location is a choice that must make no difference to the mesh: laws of Green and Sibson's algorithm
// under each.
#include "algorithms/mesh/canonical.hpp"
#include "tests/conformance/run.hpp"

#include <array>

namespace tribunal {
namespace {

const std::array<Settings, 3> locations{Settings{{"location", "history"}}, Settings{{"location", "walk"}},
                                        Settings{{"location", "jump-and-walk"}}};
const std::array<Order, 5> orders{Order::random, Order::input, Order::hilbert, Order::x, Order::brio};

Triangulation run_located(const std::vector<Point2>& points, const Settings& location,
                          Order order = Order::random, std::string_view backend = "filtered",
                          std::uint64_t seed = 1) {
  return run(points, *find_planar_algorithm("green-sibson"), backend, order, seed, location);
}

class Location : public testing::TestWithParam<const Dataset*> {
 protected:
  std::vector<Point2> points(std::uint64_t n, std::uint64_t seed) const {
    return GetParam()->generate(n, seed);
  }
};

TEST_P(Location, EachGivesTheSameMeshAndTheSameCounts) {
  for (const std::uint64_t n : {1, 2, 3, 4, 7, 30, 300})
    for (const Order order : orders) {
      const auto sites = points(n, 5);
      const Triangulation by_history = run_located(sites, locations[0], order);
      const auto verdict = check(sites, by_history);
      ASSERT_TRUE(verdict.valid()) << faults_of(verdict);
      for (const Settings& location : {locations[1], locations[2]}) {
        const Triangulation t = run_located(sites, location, order);
        ASSERT_EQ(t.outcome, Outcome::ok) << t.reason;
        EXPECT_EQ(digest(t.triangles), digest(by_history.triangles));
        EXPECT_EQ(t.counters.tau, by_history.counters.tau);
        EXPECT_EQ(t.counters.tau_with_ghosts, by_history.counters.tau_with_ghosts);
        EXPECT_EQ(t.counters.created, by_history.counters.created);
        EXPECT_EQ(t.counters.flips, by_history.counters.flips);
        EXPECT_EQ(t.counters.on_edge, by_history.counters.on_edge);
        EXPECT_EQ(t.counters.outside_hull, by_history.counters.outside_hull);
        EXPECT_EQ(t.counters.conflict_tests, by_history.counters.conflict_tests);
      }
    }
}

TEST_P(Location, OnlyTheHistoryHasAShape) {
  const auto sites = points(60, 1);
  for (const Settings& location : locations) {
    const Triangulation t = run_located(sites, location);
    const bool expected = t.dimension == 2 && location.at("location") == "history";
    EXPECT_EQ(t.history.has_value(), expected);
  }
}

// Wrong signs may spoil a mesh or end in an outcome; they may not keep a walk going.
TEST_P(Location, WrongSignsEnd) {
  for (const BackendEntry& backend : backends()) {
    if (backend.about->exact) continue;
    for (const Settings& location : locations)
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Triangulation t =
            run_located(points(150, seed), location, Order::random, backend.about->name, seed);
        EXPECT_TRUE(t.outcome == Outcome::ok || t.outcome == Outcome::inconsistent_predicate ||
                    t.outcome == Outcome::loop || t.outcome == Outcome::out_of_domain)
            << backend.about->name << ": " << to_string(t.outcome);
      }
  }
}

std::vector<const Dataset*> all_datasets() {
  std::vector<const Dataset*> all;
  for (const Dataset& dataset : datasets()) all.push_back(&dataset);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Location, testing::ValuesIn(all_datasets()),
                         [](const auto& dataset) { return test_name(dataset.param->about.name); });

// Every subset of the 3 x 3 lattice, forwards and backwards: sites on edges, on the hull and beyond its ends.
TEST(Locations, AreRightOnAllSmallLatticeSets) {
  for (int mask = 1; mask < 512; ++mask) {
    std::vector<Point2> points;
    for (int i = 0; i < 9; ++i)
      if (mask >> i & 1) points.push_back({double((i * 5) % 9 % 3), double((i * 5) % 9 / 3)});
    for (const Settings& location : locations)
      for (const Order order : {Order::input, Order::x}) {
        const Triangulation t = run_located(points, location, order, "double");  // exact on this lattice
        ASSERT_EQ(t.outcome, Outcome::ok) << mask << ": " << t.reason;
        ASSERT_TRUE(check(points, t).valid()) << mask << "\n" << faults_of(check(points, t));
      }
  }
}

// Steps are counts, so that this holds on every machine: along a curve the next site is a few triangles away,
// in random order as far as the square root of their number, after a jump as far as its cube root.
TEST(Locations, WalksAreAsLongAsTheOrderMakesThem) {
  const auto sites = find_dataset("uniform")->generate(8000, 1);
  const auto steps = [&](const Settings& location, Order order) {
    return static_cast<double>(run_located(sites, location, order).counters.location_steps) / 8000;
  };
  EXPECT_LT(steps(locations[1], Order::hilbert), 6);
  EXPECT_LT(steps(locations[1], Order::brio), 6);
  EXPECT_GT(steps(locations[1], Order::random), 40);
  EXPECT_LT(steps(locations[2], Order::random), 30);
}

// Depths by hand: the root is a leaf, then its three children, then a flip's two.
TEST(Locations, DepthCountsTheTrianglesOnThePath) {
  const std::vector<Point2> points{{0, 0}, {8, 0}, {0, 8}, {2, 2}, {1, 1.25}};
  const Settings& history = locations[0];
  const Triangulation four = run_located({points.begin(), points.end() - 1}, history, Order::input);
  EXPECT_EQ(four.history->nodes, 7U);
  EXPECT_EQ(four.history->depth_max, 1U);
  const Triangulation five = run_located(points, history, Order::input);
  EXPECT_EQ(five.history->nodes, 7U + 3 + 2 * five.counters.flips);
  EXPECT_EQ(five.history->depth_max, 2U);
  EXPECT_EQ(five.history->depth_mean, 1.5);
  EXPECT_EQ(five.history->depth_late_mean, 2);
}

}  // namespace
}  // namespace tribunal
