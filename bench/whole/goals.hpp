// How our algorithms want to compare with others, as ratios of whole runs side by side.
#pragma once

#include "bench/whole/race.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A ratio of two contestants' figures over a course, and what it ought to be at most.
struct RaceGoal {
  Method subject;
  std::optional<Method> rival_method;  ///< of ours; where there is none, the rival is a peer
  std::string peer;
  Course course;
  double at_most;
  Figure figure = Figure::time;

  std::string rival_name() const { return rival_method ? describe(*rival_method) : peer; }
};

/// The figures to reach.
std::vector<RaceGoal> race_goals();

}  // namespace tribunal::bench
