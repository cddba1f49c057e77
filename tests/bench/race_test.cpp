// Laws of races: wrong meshes have no time, rounds are side by side, goals name what there is.
#include "bench/whole/race.hpp"

#include "algorithms/list.hpp"
#include "bench/whole/goals.hpp"
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tribunal::bench {
namespace {

const Method green_sibson{.algorithm = "green-sibson"};

RaceOptions options_of(std::vector<Contestant> contestants, const char* dataset = "uniform",
                       std::uint64_t n = 100) {
  RaceOptions options;
  options.contestants = std::move(contestants);
  options.course = {dataset, n};
  options.rounds = 3;
  return options;
}

/// One that runs `green_sibson`, tells `calls` its name, and does `mischief` to the result.
Contestant stranger(const std::string& name, std::vector<std::string>& calls, void (*mischief)(Lap&)) {
  const Contestant honest = contestant_of(green_sibson, 1);
  return {name, Promise::delaunay, [=, &calls](std::span<const Point2> points) {
            calls.push_back(name);
            Lap lap = honest.run(points);
            mischief(lap);
            return lap;
          }};
}

TEST(Race, EveryVariantFinishes) {
  std::vector<Contestant> contestants;
  for (const char* location : {"history", "walk", "jump-and-walk"}) {
    Method method = green_sibson;
    method.settings = {{"location", location}};
    method.order = Order::brio;
    contestants.push_back(contestant_of(method, 7));
  }
  for (const Standing& standing : race(options_of(contestants))) {
    EXPECT_EQ(standing.outcome, Outcome::ok) << standing.reason;
    EXPECT_EQ(standing.seconds.size(), 3u);
    EXPECT_EQ(standing.course.n, 100u);
  }
}

TEST(Race, AWrongMeshHasNoTime) {
  std::vector<std::string> calls;
  const auto standings = race(options_of({
      stranger("honest", calls, [](Lap&) {}),
      stranger("gap", calls, [](Lap& lap) { lap.triangles.pop_back(); }),
      stranger("empty", calls, [](Lap& lap) { lap.triangles.clear(); }),
      stranger("lost", calls, [](Lap& lap) { lap.outcome = Outcome::loop, lap.reason = "lost"; }),
  }));
  EXPECT_EQ(standings[0].seconds.size(), 3u);
  EXPECT_EQ(standings[1].outcome, Outcome::invalid_topology);
  EXPECT_EQ(standings[2].outcome, Outcome::refused_input);
  EXPECT_EQ(standings[3].outcome, Outcome::loop);
  EXPECT_EQ(standings[3].reason, "lost");
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_TRUE(standings[i].seconds.empty());
    EXPECT_FALSE(standings[i].reason.empty());
    EXPECT_FALSE(ratio_of(standings[0], standings[i]));
  }
}

TEST(Race, RoundsAlternate) {
  std::vector<std::string> calls;
  race(options_of({stranger("a", calls, [](Lap&) {}), stranger("b", calls, [](Lap&) {})}));
  const std::vector<std::string> expected{"a", "b", "a", "b", "b", "a", "a", "b"};
  EXPECT_EQ(calls, expected);
}

TEST(Race, RepeatedPointsRunOnce) {
  const auto standings = race(options_of({contestant_of(green_sibson, 1)}, "duplicates", 100));
  EXPECT_EQ(standings[0].outcome, Outcome::ok) << standings[0].reason;
  EXPECT_LT(standings[0].course.n, 100u);
}

TEST(Race, RatiosAreOfOneRound) {
  Standing slow, fast;
  slow.seconds = {2, 40, 6};
  fast.seconds = {1, 10, 3};
  const auto ratio = ratio_of(slow, fast);
  ASSERT_TRUE(ratio);
  EXPECT_EQ(ratio->median, 2);
  EXPECT_EQ(ratio->interval.low, 2);
  EXPECT_EQ(ratio->interval.high, 4);
}

TEST(Race, GoalsNameWhatThereIs) {
  std::set<std::string> names;
  for (const RaceGoal& goal : race_goals()) {
    std::vector<Method> methods{goal.subject};
    if (goal.rival_method) methods.push_back(*goal.rival_method);
    for (const Method& method : methods) {
      const PlanarAlgorithm* algorithm = find_planar_algorithm(method.algorithm);
      ASSERT_NE(algorithm, nullptr) << method.algorithm;
      EXPECT_EQ(refuse_settings(method.algorithm, algorithm->parameters, method.settings), "");
      EXPECT_EQ(without_defaults(algorithm->parameters, method.settings), method.settings);
      EXPECT_NE(find_backend(method.backend), nullptr);
    }
    EXPECT_NE(find_dataset(goal.course.dataset), nullptr);
    EXPECT_FALSE(goal.rival_name().empty());
    EXPECT_TRUE(names.insert(describe(goal.subject) + goal.rival_name() + goal.course.dataset).second);
  }
}

}  // namespace
}  // namespace tribunal::bench
