#include "bench/whole/goals.hpp"

namespace tribunal::bench {

std::vector<RaceGoal> race_goals() {
  const Course million{"uniform", 1'000'000};
  const std::string cgal = "cgal-delaunay";
  const Method history{.algorithm = "green-sibson"};
  const Method walk{.algorithm = "green-sibson", .settings = {{"location", "walk"}}, .order = Order::brio};
  Method history_in_rounds = history;
  history_in_rounds.order = Order::brio;
  const Method flips{.algorithm = "lawson", .settings = {{"start", "halves"}}};
  return {{history, {}, cgal, million, 10},
          {history_in_rounds, {}, cgal, million, 2.5},
          {walk, {}, cgal, million, 1.5},
          {flips, {}, cgal, million, 3}};
}

}  // namespace tribunal::bench
