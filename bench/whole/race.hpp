// Whole runs, side by side: every contestant over the same ground, checked before it is timed.
#pragma once

#include "bench/campaign.hpp"
#include "bench/statistics.hpp"
#include "bench/whole/contestant.hpp"
#include "bench/whole/course.hpp"
#include "bench/whole/referee.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

/// What came of one contestant.
struct Standing {
  std::string contestant;
  Course course;
  std::uint64_t n = 0;  ///< points there were: distinct ones, or with those where segments cross
  Ruling ruling = {};
  std::vector<double> seconds = {};           ///< one value per round; none where the ruling does not stand
  std::uint64_t vertices = 0, triangles = 0;  ///< of the mesh; 0 where there is none
};

/// Its outcome's name, "ok" and so on, or "unmet_bounds".
std::string_view outcome_of(const Standing& standing);

struct RaceOptions {
  std::vector<Contestant> contestants;
  Course course;
  std::uint64_t seed = 1;  ///< of the dataset
  int rounds = 7;
  Limits limits = {.seconds = 300};  ///< of a process, which makes one lap, or a second one to be timed
  std::function<void(const Progress&)> progress = {};
};

/// Runs every contestant once and has its mesh checked exactly for what the race is about; a wrong result has
/// no time. Then times the others in rounds: within a round each runs once, every other round in opposite
/// order, so that a drift of the clock meets all alike. Each lap has a process of its own, so that whatever a
/// contestant does is an outcome; one that fails in a round is out, its times with it.
std::vector<Standing> race(const RaceOptions& options);

/// What contestants are compared by.
enum class Figure : std::uint8_t { time, triangles };

inline constexpr std::array<std::string_view, 2> figure_names{"time", "triangles"};

constexpr std::string_view to_string(Figure figure) { return figure_names[static_cast<std::size_t>(figure)]; }

/// One contestant's figure by another's. Of time, the median over rounds with its 95 % interval by bootstrap
/// over rounds; numbers of triangles are what they are.
struct Ratio {
  double median;
  Interval interval;
};

/// Of two that ran the same rounds; nothing where one of them has no time.
std::optional<Ratio> ratio_of(const Standing& subject, const Standing& rival, Figure figure = Figure::time);

}  // namespace tribunal::bench
