// Times loops side by side, with Google Benchmark as the clock.
#pragma once

#include "bench/micro/subject.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tribunal::bench {

struct StopwatchOptions {
  int rounds = 21;  ///< values per loop
  double milliseconds =
      2;  ///< the least that one value is taken over, unless a pass over all queries is longer
  /// Called after each value's pass, outside the time taken. May be empty.
  std::function<void(const SignLoop&)> after = {};
  std::function<bool()> interrupted = {};  ///< asked after each round, which then is the last; may be empty
};

/// Nanoseconds of processor time per query: one vector of `rounds` values per loop. Within a round every loop
/// runs once, every other round in opposite order, so that values of one round may be compared pair by pair:
/// a drift of the clock meets all loops alike. Fast loops pass over their `queries` queries several times,
/// and once before the clock runs; slow ones see the first of them only (1,024 or more).
std::vector<std::vector<double>> time_side_by_side(std::span<const SignLoop* const> loops,
                                                   std::size_t queries, const StopwatchOptions& options);

}  // namespace tribunal::bench
