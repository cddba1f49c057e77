// How fast the flagship wants to be, as ratios of times measured side by side.
#pragma once

#include "bench/micro/predicate_bench.hpp"
#include "bench/statistics.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

/// A ratio of two subjects' times for one predicate and family, and what it ought to be at most.
struct Goal {
  std::string_view subject, rival, family;
  Predicate predicate;
  double at_most;
};

/// The figures to reach. Those of the batched entry points are for the vectors of this machine's processor:
/// 512 bits or fewer.
std::vector<Goal> goals();

struct MeasuredGoal {
  Goal goal;
  std::optional<double>
      ratio;           ///< the median over rounds of subject / rival; none where one of them has no time
  Interval interval;   ///< 95 % of that median, by bootstrap over rounds
  std::string reason;  ///< why there is no ratio

  bool met() const { return ratio && *ratio <= goal.at_most; }
};

/// Each goal against the cells of one run. Deterministic. Goals none of whose two cells was asked for are
/// left out.
std::vector<MeasuredGoal> measure_goals(std::span<const Goal> goals, std::span<const MicroCell> cells);

}  // namespace tribunal::bench
