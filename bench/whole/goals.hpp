// How fast our algorithms want to be, as ratios of whole runs measured side by side.
#pragma once

#include "bench/whole/race.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A ratio of two contestants' times over a course, and what it ought to be at most.
struct RaceGoal {
  Method subject;
  std::optional<Method> rival_method;  ///< of ours; where there is none, the rival is a peer
  std::string peer;
  Course course;
  double at_most;

  std::string rival_name() const { return rival_method ? describe(*rival_method) : peer; }
};

/// The figures to reach.
std::vector<RaceGoal> race_goals();

}  // namespace tribunal::bench
