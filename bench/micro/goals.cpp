#include "bench/micro/goals.hpp"

#include "predicates/batch/batch.hpp"

#include <algorithm>

namespace tribunal::bench {
namespace {

const MicroCell* find(std::span<const MicroCell> cells, std::string_view subject, const Goal& goal) {
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const MicroCell& cell) {
    return cell.subject == subject && cell.predicate == goal.predicate && cell.family == goal.family;
  });
  return found == cells.end() ? nullptr : &*found;
}

std::string why_untimed(const MicroCell* cell, std::string_view subject) {
  if (!cell) return std::string(subject) + " was not asked";
  if (cell->outcome == MicroOutcome::at_fault) return std::string(subject) + ": " + cell->reason;
  return std::string(subject) + (cell->wrong != 0 ? " gives wrong signs" : " refuses: " + cell->reason);
}

MeasuredGoal measure(const Goal& goal, const MicroCell* subject, const MicroCell* rival) {
  MeasuredGoal measured{goal, std::nullopt, {}, {}};
  if (!subject || subject->nanoseconds.empty()) {
    measured.reason = why_untimed(subject, goal.subject);
  } else if (!rival || rival->nanoseconds.empty()) {
    measured.reason = why_untimed(rival, goal.rival);
  } else {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < subject->nanoseconds.size(); ++i)
      ratios.push_back(subject->nanoseconds[i] / rival->nanoseconds[i]);
    measured.interval = bootstrap_median(ratios, 1);
    measured.ratio = median(std::move(ratios));
  }
  return measured;
}

}  // namespace

std::vector<Goal> goals() {
  struct Line {
    std::string_view subject, rival, family;
    std::array<double, all_predicates.size()> at_most;
  };
  const bool wide = batch_instructions() == "avx512";
  const Line lines[] = {
      {"filtered", "double", "uni", {1.3, 1.9, 1.8, 1.9}},
      {"filtered", "cgal-epick", "uni", {0.2, 0.4, 0.25, 0.55}},
      {"filtered", "cgal-epick", "near", {0.15, 0.16, 0.18, 0.13}},
      {"filtered", "cgal-epick", "degI", {0.8, 0.12, 0.5, 0.15}},
      {"filtered", "cgal-epick", "degF", {1, 1, 1, 1}},
      {"fortune-van-wyk", "double", "int28", {1.1, 1.1, 1.1, 1.3}},
      {"filtered-batch", "filtered", "uni",
       wide ? std::array{0.35, 0.3, 0.3, 0.3} : std::array{0.6, 0.36, 0.38, 0.4}},
  };
  std::vector<Goal> all;
  for (const Line& line : lines)
    for (const Predicate predicate : all_predicates)
      all.push_back({line.subject, line.rival, line.family, predicate,
                     line.at_most[static_cast<std::size_t>(predicate)]});
  return all;
}

std::vector<MeasuredGoal> measure_goals(std::span<const Goal> goals, std::span<const MicroCell> cells) {
  std::vector<MeasuredGoal> all;
  for (const Goal& goal : goals) {
    const MicroCell* subject = find(cells, goal.subject, goal);
    const MicroCell* rival = find(cells, goal.rival, goal);
    if (subject || rival) all.push_back(measure(goal, subject, rival));
  }
  return all;
}

}  // namespace tribunal::bench
