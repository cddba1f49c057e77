#include "bench/outsider/mesh_trial.hpp"

#include "algorithms/verify/verify.hpp"
#include "bench/normalise.hpp"
#include "bench/outsider/replay.hpp"
#include "bench/outsider/watched.hpp"
#include "datasets/files/files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace tribunal::bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OutsiderMesh, end, reason, triangles, seconds)

namespace {
using nlohmann::json;

constexpr std::string_view task = "delaunay";
constexpr int most_hangs = 3;
constexpr std::size_t most_shown = 24;  // points that still fit on a command line

/// What came of one triangulation.
struct Attempt {
  Finding finding = Finding::right;
  std::string reason;
  double seconds = 0;
  std::vector<Triangle> triangles;
};

Attempt judge(std::span<const Point2> points, OutsiderMesh mesh) {
  switch (mesh.end) {
    case OutsiderMesh::End::done:
      break;
    case OutsiderMesh::End::refused:
      return {Finding::refused, std::move(mesh.reason), 0, {}};
    case OutsiderMesh::End::crash:
      return {Finding::crash, std::move(mesh.reason), 0, {}};
    case OutsiderMesh::End::garbage:
      return {Finding::wrong, std::move(mesh.reason), 0, {}};
    case OutsiderMesh::End::no_program:
      throw BadInput(mesh.reason);
  }
  if (mesh.triangles.size() > 2 * points.size())
    return {Finding::wrong, std::to_string(mesh.triangles.size()) + " triangles, more than 2n", 0, {}};
  auto triangles = normalise(points, std::move(mesh.triangles));
  const verify::Verdict verdict = verify::verify_planar(points, {.triangles = triangles});
  if (verdict.valid()) return {Finding::right, {}, mesh.seconds, std::move(triangles)};
  const verify::Fault& first = verdict.faults.front();
  return {Finding::wrong, std::string(verify::to_string(first.kind)) + ": " + first.detail, 0,
          std::move(triangles)};
}

Attempt attempt(const Triangulator& triangulator, std::span<const Point2> points,
                const TrialOptions& options) {
  const auto ending = run_unless_woken([&] { return json(triangulator.triangulate(points)).dump(); },
                                       options.limits, options.wake);
  if (!ending) return {Finding::untried, std::string(interrupted_reason), 0, {}};
  if (ending->outcome != Outcome::ok) return {finding_of(ending->outcome), ending->reason, 0, {}};
  return judge(points, json::parse(ending->result).get<OutsiderMesh>());
}

/// Fewer points for which `fails` still holds: takes away halves, quarters and so on down to single points
/// (Zeller and Hildebrandt 2002), as long as `tries` are left.
std::vector<Point2> cut_down(std::vector<Point2> points, int& tries,
                             const std::function<bool(std::span<const Point2>)>& fails) {
  for (std::size_t chunk = points.size() / 2; chunk > 0;) {
    bool cut = false;
    for (std::size_t at = 0; at < points.size() && points.size() > 1;) {
      std::vector<Point2> fewer(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(at));
      const std::size_t rest = std::min(at + chunk, points.size());
      fewer.insert(fewer.end(), points.begin() + static_cast<std::ptrdiff_t>(rest), points.end());
      if (fewer.empty() || tries == 0) return points;
      --tries;
      if (fails(fewer)) {
        points = std::move(fewer);
        cut = true;
      } else {
        at = rest;
      }
    }
    if (chunk > 1)
      chunk = std::min(chunk / 2, points.size() / 2);
    else if (!cut)
      break;
  }
  return points;
}

/// Small sizes first: a failure at four points says more than one at a thousand.
std::vector<std::uint64_t> sizes_up_to(std::uint64_t most) {
  std::vector<std::uint64_t> sizes;
  for (const std::uint64_t n : {1, 2, 3, 4, 10, 50})
    if (n < most) sizes.push_back(n);
  sizes.push_back(most);
  return sizes;
}

class MeshTrial {
 public:
  MeshTrial(const Triangulator& triangulator, const TrialOptions& options)
      : triangulator_(triangulator), options_(options), spare_runs_(triangulator.spare_runs()) {}

  const Exercise& exercise(const Dataset& dataset) {
    Exercise exercise = blank(dataset.about.name);
    if (hangs_ == most_hangs) exercise.reason = "it hung before";
    for (const std::uint64_t n : sizes_up_to(options_.points)) {
      if (hangs_ == most_hangs || failed(exercise.finding) || exercise.reason == interrupted_reason) break;
      const auto points = dataset.generate(n, options_.seed);
      const std::string replay =
          replay_dataset(triangulator_.options(), dataset.about.name, n, options_.seed);
      exercise_points(points, replay, exercise);
    }
    return result.exercises.emplace_back(std::move(exercise));
  }

  void exercise(std::string_view input, std::span<const Point2> points, const std::string& replay) {
    Exercise exercise = blank(input);
    exercise_points(points, replay, exercise);
    result.exercises.push_back(std::move(exercise));
  }

  TrialResult result;

 private:
  static Exercise blank(std::string_view input) {
    return {.task = std::string(task), .input = std::string(input), .reason = {}};
  }

  void exercise_points(std::span<const Point2> points, const std::string& replay, Exercise& exercise) {
    Attempt done = attempt(triangulator_, points, options_);
    exercise.n = points.size();
    exercise.finding = done.finding;
    exercise.reason = done.reason;
    exercise.seconds = done.seconds;
    hangs_ += done.finding == Finding::hang;
    if (failed(done.finding)) accuse(points, std::move(done), replay, exercise);
  }

  void accuse(std::span<const Point2> points, Attempt shown, const std::string& replay,
              const Exercise& exercise) {
    std::vector<Point2> fewer(points.begin(), points.end());
    if (shown.finding != Finding::hang) {  // each further one would cost its whole time
      fewer = cut_down(std::move(fewer), spare_runs_, [&](std::span<const Point2> tried) {
        Attempt again = attempt(triangulator_, tried, options_);
        if (again.finding != exercise.finding) return false;
        shown = std::move(again);
        return true;
      });
    }
    Counterexample example{.task = exercise.task,
                           .input = exercise.input,
                           .finding = exercise.finding,
                           .points = {},
                           .exact = "valid",
                           .got = shown.reason,
                           .replay = replay,
                           .triangles = {},
                           .picture = {}};
    if (fewer.size() <= most_shown) example.replay = replay_points(triangulator_.options(), fewer);
    for (const Point2& p : fewer) example.points.emplace_back(p.coordinate.begin(), p.coordinate.end());
    example.triangles = std::move(shown.triangles);
    result.counterexamples.push_back(std::move(example));
  }

  const Triangulator& triangulator_;
  const TrialOptions& options_;
  int spare_runs_;
  int hangs_ = 0;
};

}  // namespace

TrialResult try_triangulator(const Triangulator& triangulator, std::span<const Dataset> datasets,
                             const TrialOptions& options, const Watcher& watcher) {
  MeshTrial trial(triangulator, options);
  for (const Dataset& dataset : datasets)
    if (!watcher(trial.exercise(dataset))) break;
  return std::move(trial.result);
}

TrialResult try_points(const Triangulator& triangulator, std::span<const Point2> points,
                       const TrialOptions& options) {
  MeshTrial trial(triangulator, options);
  trial.exercise("points", points, replay_points(triangulator.options(), points));
  return std::move(trial.result);
}

}  // namespace tribunal::bench
