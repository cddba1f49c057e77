// Whole runs, side by side: every contestant over the same points, checked before it is timed.
#pragma once

#include "bench/campaign.hpp"
#include "bench/statistics.hpp"
#include "bench/whole/contestant.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// The points of a race.
struct Course {
  std::string dataset;
  std::uint64_t n;  ///< as asked for; of a standing, as many distinct ones as there were

  bool operator==(const Course&) const = default;
};

/// What came of one contestant.
struct Standing {
  std::string contestant;
  Course course;
  Outcome outcome = Outcome::ok;
  std::string reason;           ///< where the outcome is not ok
  std::vector<double> seconds;  ///< one value per round; none where the outcome is not ok
};

struct RaceOptions {
  std::vector<Contestant> contestants;
  Course course;
  std::uint64_t seed = 1;  ///< of the points, repetitions among which are left out
  int rounds = 7;
  std::function<void(const Progress&)> progress = {};
};

/// Runs every contestant once and has its mesh checked exactly for what it promises; a wrong result has no
/// time. Then times the others in rounds: within a round each runs once, every other round in opposite order,
/// so that a drift of the clock meets all alike.
std::vector<Standing> race(const RaceOptions& options);

/// The median over rounds of one contestant's time by another's, with its 95 % interval by bootstrap over
/// rounds.
struct Ratio {
  double median;
  Interval interval;
};

/// Of two that ran the same rounds; nothing where one of them has no time.
std::optional<Ratio> ratio_of(const Standing& subject, const Standing& rival);

}  // namespace tribunal::bench
