#include "bench/whole/goals.hpp"

namespace tribunal::bench {
namespace {

void add_point_goals(std::vector<RaceGoal>& goals) {
  const Course million{"uniform", 1'000'000};
  const std::string cgal = "cgal-delaunay";
  const Method history{.algorithm = "green-sibson"};
  const Method walk{.algorithm = "green-sibson", .settings = {{"location", "walk"}}, .order = Order::brio};
  Method history_in_rounds = history;
  history_in_rounds.order = Order::brio;
  const Method flips{.algorithm = "lawson", .settings = {{"start", "halves"}}};
  goals.insert(goals.end(), {{history, {}, cgal, million, 10},
                             {history_in_rounds, {}, cgal, million, 2.5},
                             {walk, {}, cgal, million, 1.5},
                             {flips, {}, cgal, million, 3}});
}

/// The course is the one that the method is raced over on that dataset, all of it.
void add_goal(std::vector<RaceGoal>& goals, const Method& subject, const char* dataset, double at_most,
              Figure figure = Figure::time) {
  goals.push_back(
      {subject, {}, "cgal-mesher", course_of(subject, *find_dataset(dataset), 0), at_most, figure});
}

}  // namespace

std::vector<RaceGoal> race_goals() {
  std::vector<RaceGoal> goals;
  add_point_goals(goals);
  add_goal(goals, {.algorithm = "constrained", .order = Order::brio}, "counties", 0.7);
  // To about 200,000 triangles, with the bound at which the rival is proved to end, and with Chew's.
  for (const char* angle : {"20.7", "30"}) {
    Method chew{.algorithm = "chew", .settings = {{"angle", angle}, {"size", "52"}}, .order = Order::hilbert};
    if (chew.settings["angle"] == "30") chew.settings.erase("angle");  // it is standard
    add_goal(goals, chew, "gulf", 1);
    add_goal(goals, chew, "gulf", 1.1, Figure::triangles);
  }
  return goals;
}

}  // namespace tribunal::bench
