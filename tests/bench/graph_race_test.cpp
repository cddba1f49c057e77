// Laws of races over segments and domains: a mesh must be of the ground that was given, and within its
// bounds.
#include "bench/whole/race.hpp"
#include "bench/whole/referee.hpp"
#include "datasets/files/files.hpp"
#include "predicates/plugin/library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tribunal::bench {
namespace {

const Method any_constrained{.algorithm = "constrained", .order = Order::brio};

Method chew_to(const char* angle, const char* size) {
  return {.algorithm = "chew", .settings = {{"angle", angle}, {"size", size}}, .order = Order::hilbert};
}

RaceOptions race_of(const std::vector<Method>& methods, const char* dataset, std::uint64_t n = 100) {
  RaceOptions options;
  options.course = course_of(methods[0], *find_dataset(dataset), n);
  options.rounds = 2;
  for (const Method& method : methods)
    options.contestants.push_back(contestant_of(method, options.course.kind, 1));
  return options;
}

/// The unit square, its sides as segments, within easy bounds.
Ground square_ground() {
  return {.points = {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}},
          .segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
          .holes = {},
          .bounds = {.sine_squared = 0.25, .longest_edge = 1}};
}

/// Four triangles around the middle of the square.
Lap four_triangles() {
  return {.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
          .vertices = {{{0.5, 0.5}}},
          .subsegments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
}

Ruling judge_over(const Ground& ground, const Lap& lap, RaceKind kind = RaceKind::refinement) {
  return Referee(ground, kind).judge(lap, Promise::delaunay);
}

TEST(GraphRace, WhatIsRacedFollowsFromMethodAndDataset) {
  const auto kind = [](const Method& method, const char* dataset) {
    return course_of(method, *find_dataset(dataset), 10).kind;
  };
  EXPECT_EQ(kind(any_constrained, "uniform"), RaceKind::triangulation);
  EXPECT_EQ(kind(any_constrained, "comb"), RaceKind::graph);
  EXPECT_EQ(kind(any_constrained, "counties"), RaceKind::graph);
  EXPECT_EQ(kind({.algorithm = "bowyer"}, "comb"), RaceKind::triangulation);
  EXPECT_EQ(kind(chew_to("20", "9"), "gulf"), RaceKind::refinement);
  const Course course = course_of(chew_to("30", "9"), *find_dataset("gulf"), 10);
  EXPECT_EQ(course.n, 0u) << "all of it";
  EXPECT_DOUBLE_EQ(course.bounds.sine_squared, 0.25);
  EXPECT_EQ(course.bounds.longest_edge, 9);
  EXPECT_THROW(kind(chew_to("20", "9"), "uniform"), BadInput);
  EXPECT_THROW(kind(chew_to("20", "9"), "counties"), BadInput) << "borders enclose no domain";
  EXPECT_THROW(kind(chew_to("20", "boundary"), "gulf"), BadInput);
  EXPECT_THROW(kind({.algorithm = "constrained", .settings = {{"domain", "carved"}}}, "gulf"), BadInput);
}

TEST(GraphRace, SegmentsThatCrossAreSplitBeforehand) {
  const Ground ground = ground_of({"counties", 0, RaceKind::graph}, 1);
  EXPECT_GT(ground.points.size(), 46'565u) << "three pairs of borders cross";
  for (const Standing& standing : race(race_of({any_constrained}, "counties"))) {
    EXPECT_EQ(standing.ruling.outcome, Outcome::ok) << standing.ruling.reason;
    EXPECT_EQ(standing.n, ground.points.size());
  }
}

TEST(GraphRace, BothRecoveriesFinish) {
  Method swaps = any_constrained;
  swaps.settings = {{"recovery", "swaps"}};
  const auto standings = race(race_of({any_constrained, swaps}, "fractal-coast", 200));
  for (const Standing& standing : standings) {
    EXPECT_EQ(standing.ruling.outcome, Outcome::ok) << standing.ruling.reason;
    EXPECT_EQ(standing.seconds.size(), 2u);
    EXPECT_GT(standing.triangles, 100u);
  }
  EXPECT_EQ(standings[0].triangles, standings[1].triangles);
}

TEST(GraphRace, ATriangulationThatForgetsTheSegmentsIsNone) {
  RaceOptions options = race_of({any_constrained}, "fractal-coast", 200);
  const Contestant plain = contestant_of({.algorithm = "bowyer"}, RaceKind::triangulation, 1);
  options.contestants.push_back(plain);
  const auto standings = race(options);
  EXPECT_EQ(standings[0].ruling.outcome, Outcome::ok) << standings[0].ruling.reason;
  EXPECT_EQ(standings[1].ruling.outcome, Outcome::invalid_topology);
  EXPECT_EQ(standings[1].triangles, 0u);
}

TEST(GraphRace, RefinementKeepsItsBounds) {
  for (const auto& [angle, dataset] :
       {std::pair{"20.7", "gulf"}, {"30", "gulf"}, {"30", "wedge"}, {"30", "fan"}}) {
    const auto standings = race(race_of({chew_to(angle, "1000")}, dataset));
    EXPECT_EQ(standings[0].ruling.outcome, Outcome::ok) << dataset << ": " << standings[0].ruling.reason;
    EXPECT_GT(standings[0].vertices, standings[0].n);
  }
}

TEST(GraphRace, AMeshWithoutTheBoundsHasNoTime) {
  RaceOptions options = race_of({chew_to("30", "400")}, "gulf");
  options.contestants.push_back(contestant_of(chew_to("30", "800"), RaceKind::refinement, 1));
  options.contestants.push_back(contestant_of(chew_to("10", "400"), RaceKind::refinement, 1));
  const auto standings = race(options);
  EXPECT_EQ(standings[0].ruling.outcome, Outcome::ok) << standings[0].ruling.reason;
  for (const std::size_t i : {1, 2}) {
    EXPECT_EQ(outcome_of(standings[i]), "unmet_bounds");
    EXPECT_TRUE(standings[i].seconds.empty());
  }
  EXPECT_NE(standings[1].ruling.reason.find("an edge of"), std::string::npos) << standings[1].ruling.reason;
  EXPECT_NE(standings[2].ruling.reason.find("degrees"), std::string::npos) << standings[2].ruling.reason;
}

TEST(GraphRace, RightMeshesOfASquareAreFound) {
  EXPECT_TRUE(judge_over(square_ground(), four_triangles()).stands());
  Lap turned = four_triangles();
  std::swap(turned.triangles[2][0], turned.triangles[2][1]);
  turned.subsegments.push_back({1, 0});
  EXPECT_EQ(judge_over(square_ground(), turned).outcome, Outcome::ok)
      << "orientation and repetition are free";
  EXPECT_EQ(judge_over(square_ground(), {.triangles = {{0, 1, 2}, {0, 3, 2}}}, RaceKind::graph).outcome,
            Outcome::ok);
}

TEST(GraphRace, WrongMeshesOfASquareAreFound) {
  const auto expect = [](Outcome outcome, const char* told, void (*mischief)(Lap&)) {
    Lap lap = four_triangles();
    mischief(lap);
    const Ruling ruling = judge_over(square_ground(), lap);
    EXPECT_EQ(ruling.outcome, outcome) << told;
    EXPECT_NE(ruling.reason.find(told), std::string::npos) << ruling.reason;
    EXPECT_FALSE(ruling.stands());
  };
  expect(Outcome::invalid_topology, "wrong_domain", [](Lap& lap) { lap.triangles.pop_back(); });
  expect(Outcome::invalid_topology, "no point", [](Lap& lap) { lap.triangles[0][0] = 5; });
  expect(Outcome::invalid_topology, "no point", [](Lap& lap) { lap.subsegments[0][0] = 5; });
  expect(Outcome::invalid_topology, "not finite", [](Lap& lap) { lap.vertices[0] = {{NAN, 0}}; });
  expect(Outcome::invalid_topology, "part of no segment", [](Lap& lap) {
    lap.subsegments.push_back({0, 4});
  });
  expect(Outcome::ok, "an angle of", [](Lap& lap) { lap.vertices[0] = {{0.5, 0.2}}; });
}

TEST(GraphRace, PartsOfASegmentLieOnIt) {
  Ground ground = square_ground();
  Lap lap{.triangles = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}},
          .vertices = {{{0.5, 0}}},
          .subsegments = {{0, 4}, {4, 1}, {1, 2}, {2, 3}, {3, 0}}};
  ground.bounds = {.sine_squared = 0.1, .longest_edge = 2};
  EXPECT_TRUE(judge_over(ground, lap).stands());
  lap.vertices[0] = {{0.5, 0x1p-50}};
  EXPECT_TRUE(judge_over(ground, lap).stands()) << "rounding is no bend";
  lap.vertices[0] = {{0.5, 0.01}};
  const Ruling bent = judge_over(ground, lap);
  EXPECT_EQ(bent.outcome, Outcome::invalid_topology);
  EXPECT_EQ(bent.reason, "segment 0 1 breaks off at 0");
}

TEST(GraphRace, SmallAnglesAreExcusedWhereSegmentsEncloseThem) {
  Ground ground{.points = {{{0, 0}}, {{8, 0}}, {{8, 1}}},
                .segments = {{0, 1}, {1, 2}, {2, 0}},
                .holes = {},
                .bounds = {.sine_squared = 0.25}};
  const Lap lap{.triangles = {{0, 1, 2}}, .subsegments = {{0, 1}, {1, 2}, {2, 0}}};
  EXPECT_TRUE(judge_over(ground, lap).stands());
  ground.bounds.longest_edge = 8;
  EXPECT_FALSE(judge_over(ground, lap).within_bounds) << "length is never excused";
}

TEST(GraphRace, SmallAnglesElsewhereAreNotExcused) {
  const Ground ground{.points = {{{0, 0}}, {{8, 0}}, {{8, 1}}, {{0, 1}}},
                      .segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                      .holes = {},
                      .bounds = {.sine_squared = 0.25}};
  const Lap lap{.triangles = {{0, 1, 2}, {0, 2, 3}}, .subsegments = ground.segments};
  EXPECT_EQ(judge_over(ground, lap).outcome, Outcome::ok);
  EXPECT_FALSE(judge_over(ground, lap).within_bounds);
}

TEST(GraphRace, MeshersOfModulesAreAsked) {
  const Ground ground = square_ground();
  for (const RaceKind kind : {RaceKind::graph, RaceKind::refinement}) {
    const auto honest = peer_contestant(TRIBUNAL_SAMPLE_MESHER, kind);
    const auto careless = peer_contestant(TRIBUNAL_SAMPLE_MESHER_GAP, kind);
    ASSERT_TRUE(honest && careless);
    EXPECT_EQ(honest->name, "sample");
    const Lap lap = honest->run(ground);
    EXPECT_EQ(judge_over(ground, lap, kind).outcome, Outcome::ok) << judge_over(ground, lap, kind).reason;
    EXPECT_EQ(judge_over(ground, careless->run(ground), kind).outcome, Outcome::invalid_topology);
    EXPECT_FALSE(peer_contestant(TRIBUNAL_NO_PEER, kind));
    EXPECT_THROW(peer_contestant(TRIBUNAL_SAMPLE_MESHER_IDLE, kind), PluginError);
    const Ground open{.points = ground.points, .segments = {{0, 1}}};
    EXPECT_EQ(honest->run(open).outcome, Outcome::refused_input);
  }
  EXPECT_FALSE(peer_contestant(TRIBUNAL_SAMPLE_MESHER, RaceKind::triangulation));
}

TEST(GraphRace, AMesherThatHangsIsAnOutcome) {
  for (const RaceKind kind : {RaceKind::graph, RaceKind::refinement}) {
    const auto idler = peer_contestant(TRIBUNAL_SAMPLE_MESHER_HANG, kind).value();
    RaceOptions options =
        race_of({kind == RaceKind::graph ? any_constrained : chew_to("30", "1000")}, "gulf");
    options.contestants.push_back(idler);
    options.limits.seconds = 3;
    const auto standings = race(options);
    EXPECT_EQ(standings[0].ruling.outcome, Outcome::ok) << standings[0].ruling.reason;
    EXPECT_EQ(standings[0].seconds.size(), 2u);
    EXPECT_EQ(standings[1].ruling.outcome, Outcome::timeout);
    EXPECT_FALSE(ratio_of(standings[0], standings[1]));
  }
}

TEST(GraphRace, AMesherThatLeavesTheRoundingModeChangedHasNoTime) {
  const auto peer = peer_contestant(TRIBUNAL_SAMPLE_MESHER_ROUNDING, RaceKind::graph).value();
  const Lap lap = run_apart([&] { return peer.run(square_ground()); }, {});
  EXPECT_NE(lap.outcome, Outcome::ok);
  EXPECT_NE(lap.reason.find("floating-point environment"), std::string::npos) << lap.reason;
}

TEST(GraphRace, TrianglesAreComparedAsTheyAre) {
  Standing subject, rival;
  subject.seconds = rival.seconds = {1, 2};
  subject.triangles = 30;
  rival.triangles = 40;
  const auto ratio = ratio_of(subject, rival, Figure::triangles);
  ASSERT_TRUE(ratio);
  EXPECT_EQ(ratio->median, 0.75);
  EXPECT_EQ(ratio->interval.high, 0.75);
}

}  // namespace
}  // namespace tribunal::bench
