// Parameters: what is accepted, what is refused and why, and what reaches an algorithm.
#include "algorithms/parameter.hpp"

#include "algorithms/abandon.hpp"
#include "tests/conformance/run.hpp"

#include <array>

namespace tribunal {
namespace {

constexpr Parameter rounds{
    .name = "rounds", .summary = "how many", .standard = "3", .least = 1, .most = 9, .choices = nullptr};
constexpr Parameter colour{.name = "colour", .summary = "of it", .standard = "red", .choices = [] {
                             return std::vector<std::string_view>{"green", "red"};
                           }};
constexpr std::array both{rounds, colour};
enum class Colour { green, red };

TEST(Parameters, WhatIsLeftOutHasItsDefault) {
  EXPECT_EQ(whole_number({}, rounds), 3u);
  EXPECT_EQ(whole_number({{"rounds", "9"}}, rounds), 9u);
  EXPECT_EQ(choice({}, colour), "red");
  EXPECT_EQ(choice_as<Colour>({}, colour), Colour::red);
  EXPECT_EQ(choice_as<Colour>({{"colour", "green"}}, colour), Colour::green);
}

TEST(Parameters, RefusalsSayWhatThereIs) {
  EXPECT_EQ(refuse_settings("it", both, {{"rounds", "9"}, {"colour", "red"}}), "");
  EXPECT_EQ(refuse_settings("it", both, {}), "");
  EXPECT_EQ(refuse_settings("it", both, {{"rounds", "10"}}),
            "rounds is a whole number from 1 to 9, not \"10\"");
  EXPECT_EQ(refuse_settings("it", both, {{"colour", "blue"}}), "colour is one of green, red, not \"blue\"");
  EXPECT_EQ(refuse_settings("it", both, {{"size", "1"}}),
            "it has no parameter \"size\" (there is rounds, colour)");
  EXPECT_EQ(refuse_settings("it", {}, {{"size", "1"}}), "it takes no parameters");
  for (const char* number : {"", "-1", "+1", "1.0", " 1", "0x1", "99999999999999999999"})
    EXPECT_FALSE(refuse(rounds, number).empty()) << number;
}

TEST(Parameters, SpellingsOfOneVariantAreEqual) {
  EXPECT_EQ(without_defaults(both, {{"rounds", "3"}, {"colour", "green"}}), (Settings{{"colour", "green"}}));
  EXPECT_EQ(without_defaults(both, {{"colour", "red"}}), Settings{});
}

// An algorithm that gives up with the settings it was given.
Triangulation tell(const PlanarProblem& problem) {
  throw Abandon(Outcome::loop,
                choice(problem.settings, colour) + std::to_string(whole_number(problem.settings, rounds)));
}
constexpr PlanarAlgorithm teller{
    .about = {.name = "teller", .dimension = 2, .cites = "", .summary = ""}, .parameters = both, .run = tell};

TEST(Parameters, TheFrontDoorHandsOnWhatItAccepts) {
  const std::vector<Point2> points{{0, 0}, {1, 0}, {0, 1}};
  const std::vector<Index> order{0, 1, 2};
  const Kernel2Binding bound = find_backend("gmp")->bind2(points);
  const Kernel2& kernel = *std::get<0>(bound);
  EXPECT_EQ(triangulate(points, order, kernel, teller).reason, "red3");
  EXPECT_EQ(triangulate(points, order, kernel, teller, {{"colour", "green"}}).reason, "green3");
  const Triangulation refused = triangulate(points, order, kernel, teller, {{"rounds", "0"}});
  EXPECT_EQ(refused.outcome, Outcome::refused_input);
  EXPECT_EQ(refused.reason, refuse(rounds, "0"));
}

// Whoever lists an algorithm's parameters must be able to use each value they list.
TEST(Parameters, EveryListedDefaultIsAValue) {
  for (const PlanarAlgorithm& algorithm : planar_algorithms())
    for (const Parameter& parameter : algorithm.parameters) {
      EXPECT_EQ(refuse(parameter, parameter.standard), "") << algorithm.about.name;
      EXPECT_EQ(find_parameter(algorithm.parameters, parameter.name), &parameter) << "a name comes twice";
      EXPECT_FALSE(parameter.summary.empty());
    }
}

}  // namespace
}  // namespace tribunal
