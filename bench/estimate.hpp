// How long is still to go, from what the cells so far have cost.
#pragma once

#include "bench/row.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace tribunal::bench {

/// Cells of one task, backend, dataset and measure are taken to cost in proportion to n times their runs; a
/// group of which none has run yet costs what the groups that have run do on average. That is too little
/// where cost grows faster than n and the large cells come last: the estimate then grows, and says so by
/// growing.
class Estimate {
 public:
  explicit Estimate(std::span<const Cell* const> cells);

  /// A cell has ended after so many seconds.
  void note(const Cell& cell, double seconds);

  /// Seconds of work left, on `jobs` children at once; nothing before the first cell has ended.
  std::optional<double> seconds_left(int jobs) const;

 private:
  struct Group {
    double seconds = 0, weight_done = 0, weight_left = 0;
  };
  std::map<std::string, Group> groups_;
};

}  // namespace tribunal::bench
