#include "bench/whole/race.hpp"

#include "algorithms/mesh/canonical.hpp"
#include "bench/input.hpp"
#include "bench/judge.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tribunal::bench {
namespace {

/// Checks meshes. Most contestants make the same one, which is looked at once.
class Referee {
 public:
  explicit Referee(std::span<const Point2> points) : points_(points) {}

  Judgement judge(Lap lap, Promise promise) {
    if (lap.outcome != Outcome::ok) return {lap.outcome, lap.reason};
    if (lap.triangles.empty()) return {Outcome::refused_input, "the points span no triangle"};
    auto& known = verdicts_[{digest(lap.triangles), promise}];
    if (!known) {
      Triangulation mesh;
      mesh.dimension = 2;
      mesh.triangles = std::move(lap.triangles);
      known = bench::judge(points_, mesh, promise);
    }
    return *known;
  }

 private:
  std::span<const Point2> points_;
  std::map<std::pair<std::uint64_t, Promise>, std::optional<Judgement>> verdicts_;
};

}  // namespace

std::vector<Standing> race(const RaceOptions& options) {
  const auto points =
      distinct_points(find_dataset(options.course.dataset)->generate(options.course.n, options.seed));
  const Course course{options.course.dataset, points.size()};
  Progress progress;
  progress.total = options.contestants.size() * (1 + static_cast<std::size_t>(options.rounds));
  const auto report = [&] {
    ++progress.done;
    if (options.progress) options.progress(progress);
  };
  std::vector<Standing> standings;
  std::vector<std::size_t> running;
  Referee referee(points);
  for (const Contestant& contestant : options.contestants) {
    const Judgement judgement = referee.judge(contestant.run(points), contestant.promise);
    if (judgement.outcome == Outcome::ok)
      running.push_back(standings.size());
    else
      progress.total -= static_cast<std::size_t>(options.rounds);
    progress.failures += judgement.outcome != Outcome::ok;
    standings.push_back({contestant.name, course, judgement.outcome, judgement.reason, {}});
    report();
  }
  for (int round = 0; round < options.rounds; ++round) {
    for (const std::size_t i : running) {
      standings[i].seconds.push_back(options.contestants[i].run(points).seconds);
      report();
    }
    std::reverse(running.begin(), running.end());
  }
  return standings;
}

std::optional<Ratio> ratio_of(const Standing& subject, const Standing& rival) {
  if (subject.seconds.empty() || rival.seconds.empty()) return std::nullopt;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < subject.seconds.size(); ++i)
    ratios.push_back(subject.seconds[i] / rival.seconds[i]);
  const Interval interval = bootstrap_median(ratios, 1);
  return Ratio{median(std::move(ratios)), interval};
}

}  // namespace tribunal::bench
