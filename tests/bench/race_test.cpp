// Laws of races: wrong meshes have no time, rounds are side by side, goals name what there is.
#include "bench/whole/race.hpp"

#include "algorithms/list.hpp"
#include "algorithms/refiners.hpp"
#include "bench/whole/goals.hpp"
#include "predicates/backends/list.hpp"
#include "tests/bench/support.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <thread>

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

/// A file that contestants, each in a process of its own, write into.
class Diary {
 public:
  void write(const std::string& name) const {
    std::ofstream(folder_ / "diary", std::ios::app) << name << ' ';
  }
  std::string text() const {
    std::ifstream file(folder_ / "diary");
    std::string text;
    std::getline(file, text);
    return text;
  }

 private:
  TemporaryFolder folder_;
};

/// One that runs `green_sibson`, writes its name down, and does `mischief` to the result.
Contestant stranger(const std::string& name, const Diary& diary, std::function<void(Lap&)> mischief) {
  const Contestant honest = contestant_of(green_sibson, RaceKind::triangulation, 1);
  return {name, Promise::delaunay, [=, &diary](const Ground& ground) {
            diary.write(name);
            Lap lap = honest.run(ground);
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
    contestants.push_back(contestant_of(method, RaceKind::triangulation, 7));
  }
  for (const Standing& standing : race(options_of(contestants))) {
    EXPECT_EQ(standing.ruling.outcome, Outcome::ok) << standing.ruling.reason;
    EXPECT_EQ(standing.seconds.size(), 3u);
    EXPECT_EQ(standing.n, 100u);
    EXPECT_EQ(standing.vertices, 100u);
    EXPECT_GT(standing.triangles, 100u);
  }
}

TEST(Race, AWrongMeshHasNoTime) {
  const Diary diary;
  const auto standings = race(options_of({
      stranger("honest", diary, [](Lap&) {}),
      stranger("gap", diary, [](Lap& lap) { lap.triangles.pop_back(); }),
      stranger("empty", diary, [](Lap& lap) { lap.triangles.clear(); }),
      stranger("lost", diary, [](Lap& lap) { lap.outcome = Outcome::loop, lap.reason = "lost"; }),
  }));
  EXPECT_EQ(standings[0].seconds.size(), 3u);
  EXPECT_EQ(standings[1].ruling.outcome, Outcome::invalid_topology);
  EXPECT_EQ(standings[2].ruling.outcome, Outcome::refused_input);
  EXPECT_EQ(standings[3].ruling.outcome, Outcome::loop);
  EXPECT_EQ(standings[3].ruling.reason, "lost");
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_TRUE(standings[i].seconds.empty());
    EXPECT_FALSE(standings[i].ruling.reason.empty());
    EXPECT_FALSE(ratio_of(standings[0], standings[i]));
  }
}

TEST(Race, RoundsAlternate) {
  const Diary diary;
  race(options_of({stranger("a", diary, [](Lap&) {}), stranger("b", diary, [](Lap&) {})}));
  EXPECT_EQ(diary.text(), "a b a a b b b b a a a a b b ") << "checked, then to warm up and timed";
}

TEST(Race, WhatAContestantDoesIsAnOutcomeOfItsOwn) {
  const Diary diary;
  RaceOptions options = options_of({
      stranger("honest", diary, [](Lap&) {}),
      stranger("crashes", diary, [](Lap&) { std::abort(); }),
      stranger("hangs", diary, [](Lap&) { std::this_thread::sleep_for(std::chrono::hours(1)); }),
      stranger("throws", diary, [](Lap&) { throw std::runtime_error("no more"); }),
  });
  options.limits.seconds = 2;
  const auto standings = race(options);
  EXPECT_EQ(standings[0].seconds.size(), 3u);
  EXPECT_EQ(standings[1].ruling.outcome, Outcome::crash);
  EXPECT_EQ(standings[2].ruling.outcome, Outcome::timeout);
  EXPECT_EQ(standings[3].ruling.reason, "exception: no more");
}

TEST(Race, WhoFailsInARoundIsOut) {
  const Diary diary;
  std::size_t done = 0, total = 0;
  RaceOptions options = options_of({
      stranger("a", diary, [](Lap&) {}),
      stranger("b", diary,
               [&diary](Lap& lap) {
                 if (diary.text().size() > std::string("a b a a b b b ").size())
                   lap.outcome = Outcome::loop, lap.reason = "tired";
               }),
  });
  options.progress = [&](const Progress& progress) { done = progress.done, total = progress.total; };
  const auto standings = race(options);
  EXPECT_EQ(standings[0].seconds.size(), 3u);
  EXPECT_EQ(standings[1].ruling.outcome, Outcome::loop);
  EXPECT_EQ(standings[1].ruling.reason, "tired");
  EXPECT_TRUE(standings[1].seconds.empty());
  EXPECT_EQ(done, total);
}

TEST(Race, RepeatedPointsRunOnce) {
  const auto standings =
      race(options_of({contestant_of(green_sibson, RaceKind::triangulation, 1)}, "duplicates", 100));
  EXPECT_EQ(standings[0].ruling.outcome, Outcome::ok) << standings[0].ruling.reason;
  EXPECT_LT(standings[0].n, 100u);
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
      const refinement::Refiner* refiner = refinement::find_refiner(method.algorithm);
      ASSERT_TRUE(algorithm || refiner) << method.algorithm;
      const auto parameters = algorithm ? algorithm->parameters : refiner->parameters;
      EXPECT_EQ(refuse_settings(method.algorithm, parameters, method.settings), "");
      EXPECT_EQ(without_defaults(parameters, method.settings), method.settings);
      EXPECT_NE(find_backend(method.backend), nullptr);
    }
    const Dataset* dataset = find_dataset(goal.course.dataset);
    ASSERT_NE(dataset, nullptr);
    EXPECT_EQ(course_of(goal.subject, *dataset, goal.course.n), goal.course) << describe(goal.subject);
    EXPECT_FALSE(goal.rival_name().empty());
    EXPECT_TRUE(names
                    .insert(describe(goal.subject) + goal.rival_name() + goal.course.dataset +
                            std::string(to_string(goal.figure)))
                    .second);
  }
}

}  // namespace
}  // namespace tribunal::bench
