#include "bench/estimate.hpp"

#include <algorithm>

namespace tribunal::bench {
namespace {

std::string group_of(const Cell& cell) {
  return cell.task + ' ' + cell.backend + ' ' + cell.dataset + (cell.measure == Measure::time ? " time" : "");
}

double weight(const Cell& cell) {
  return static_cast<double>(std::max<std::uint64_t>(cell.n, 1)) * (cell.repeats + 1);
}

}  // namespace

Estimate::Estimate(std::span<const Cell* const> cells) {
  for (const Cell* cell : cells) groups_[group_of(*cell)].weight_left += weight(*cell);
}

void Estimate::note(const Cell& cell, double seconds) {
  Group& group = groups_[group_of(cell)];
  group.seconds += seconds;
  group.weight_done += weight(cell);
  group.weight_left -= weight(cell);
}

std::optional<double> Estimate::seconds_left(int jobs) const {
  double seconds = 0, weight_done = 0, left = 0, left_of_unknown = 0;
  for (const auto& [name, group] : groups_) {
    seconds += group.seconds;
    weight_done += group.weight_done;
    if (group.weight_done > 0)
      left += group.weight_left * group.seconds / group.weight_done;
    else
      left_of_unknown += group.weight_left;
  }
  if (weight_done == 0) return std::nullopt;
  return (left + left_of_unknown * seconds / weight_done) / jobs;
}

}  // namespace tribunal::bench
