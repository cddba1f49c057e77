#include "bench/whole/race.hpp"

#include <algorithm>
#include <utility>

namespace tribunal::bench {
namespace {

/// One race while it is run.
class Heat {
 public:
  explicit Heat(const RaceOptions& options)
      : options_(options),
        ground_(ground_of(options.course, options.seed)),
        referee_(ground_, options.course.kind) {
    progress_.total = options.contestants.size() * (1 + static_cast<std::size_t>(options.rounds));
  }

  void check(std::size_t i) {
    const Contestant& contestant = options_.contestants[i];
    const Lap lap = run_apart([&] { return contestant.run(ground_); }, options_.limits);
    Standing standing{contestant.name, options_.course, ground_.points.size()};
    const Ruling ruling = referee_.judge(lap, contestant.promise);
    if (ruling.stands()) {
      standing.vertices = ground_.points.size() + lap.vertices.size();
      standing.triangles = lap.triangles.size();
    }
    standings_.push_back(std::move(standing));
    settle(i, ruling, options_.rounds);
  }

  void time(std::size_t i, int rounds_left) {
    const Lap lap = time_apart([&] { return options_.contestants[i].run(ground_); }, options_.limits);
    standings_[i].seconds.push_back(lap.seconds);
    settle(i, {lap.outcome, lap.reason}, rounds_left);
  }

  bool is_running(std::size_t i) const { return standings_[i].ruling.stands(); }
  std::vector<Standing> result() && { return std::move(standings_); }

 private:
  void settle(std::size_t i, const Ruling& ruling, int rounds_left) {
    Standing& standing = standings_[i];
    standing.ruling = ruling;
    if (!ruling.stands()) {
      standing.seconds.clear();
      standing.vertices = standing.triangles = 0;
      ++progress_.failures;
      progress_.total -= static_cast<std::size_t>(rounds_left);
    }
    ++progress_.done;
    if (options_.progress) options_.progress(progress_);
  }

  const RaceOptions& options_;
  Ground ground_;
  Referee referee_;
  Progress progress_;
  std::vector<Standing> standings_;
};

}  // namespace

std::string_view outcome_of(const Standing& standing) {
  return standing.ruling.within_bounds ? to_string(standing.ruling.outcome) : "unmet_bounds";
}

std::vector<Standing> race(const RaceOptions& options) {
  Heat heat(options);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < options.contestants.size(); ++i) {
    heat.check(i);
    order.push_back(i);
  }
  for (int left = options.rounds; left > 0; --left) {
    for (const std::size_t i : order)
      if (heat.is_running(i)) heat.time(i, left - 1);
    std::reverse(order.begin(), order.end());
  }
  return std::move(heat).result();
}

std::optional<Ratio> ratio_of(const Standing& subject, const Standing& rival, Figure figure) {
  if (subject.seconds.empty() || rival.seconds.empty()) return std::nullopt;
  if (figure == Figure::triangles) {
    const double ratio = static_cast<double>(subject.triangles) / static_cast<double>(rival.triangles);
    return Ratio{ratio, {ratio, ratio}};
  }
  std::vector<double> ratios;
  for (std::size_t i = 0; i < subject.seconds.size(); ++i)
    ratios.push_back(subject.seconds[i] / rival.seconds[i]);
  const Interval interval = bootstrap_median(ratios, 1);
  return Ratio{median(std::move(ratios)), interval};
}

}  // namespace tribunal::bench
