#include "bench/whole/referee.hpp"

#include "algorithms/duplicates.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "bench/judge.hpp"
#include "bench/normalise.hpp"
#include "bench/whole/conformity.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tribunal::bench {
namespace {

Ruling ruling_of(Judgement judgement) { return {judgement.outcome, std::move(judgement.reason)}; }
Ruling ruling_of(const verify::Verdict& verdict) { return ruling_of(judgement_of(verdict)); }

Ruling judge_points(const Ground& ground, const Lap& lap, Promise promise) {
  Triangulation mesh;
  mesh.dimension = 2;
  mesh.triangles = lap.triangles;
  return ruling_of(judge(ground.points, mesh, promise));
}

Ruling judge_graph(const Ground& ground, const Lap& lap) {
  const auto triangles = normalise(ground.points, lap.triangles);
  return ruling_of(verify::verify_constrained(ground.points, {triangles}, {ground.segments}));
}

/// What must hold before anything can be looked up by these numbers.
bool is_finite(Point2 p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }
template <class Simplices>
bool in_range(const Simplices& simplices, std::size_t points) {
  return std::ranges::all_of(simplices, [&](const auto& simplex) {
    return std::ranges::all_of(simplex, [&](Index v) { return v < points; });
  });
}

Ruling judge_refined(const Ground& ground, Lap lap) {
  std::vector<Point2> points = ground.points;
  points.insert(points.end(), lap.vertices.begin(), lap.vertices.end());
  if (!std::ranges::all_of(lap.vertices, is_finite))
    return {Outcome::invalid_topology, "a new vertex is not finite"};
  if (!in_range(lap.triangles, points.size()) || !in_range(lap.subsegments, points.size()))
    return {Outcome::invalid_topology, "a corner or an end is no point"};
  const auto triangles = normalise(points, std::move(lap.triangles));
  const std::vector<Index> first = first_occurrences(points);
  for (Edge& ends : lap.subsegments) ends = undirected(first[ends[0]], first[ends[1]]);
  std::ranges::sort(lap.subsegments);
  lap.subsegments.erase(std::unique(lap.subsegments.begin(), lap.subsegments.end()), lap.subsegments.end());
  Ruling ruling = ruling_of(verify::verify_constrained(
      points, {triangles}, {lap.subsegments, ground.holes, verify::Domain::carved}));
  if (!ruling.stands()) return ruling;
  const RefinedMesh mesh{points, triangles, lap.subsegments};
  const SegmentPaths paths = follow_segments(ground, mesh);
  if (!paths.fault.empty()) return {Outcome::invalid_topology, paths.fault};
  ruling.reason = unmet_bound(ground, mesh, paths);
  ruling.within_bounds = ruling.reason.empty();
  return ruling;
}

}  // namespace

Ruling Referee::judge_mesh(const Lap& lap, Promise promise) const {
  switch (kind_) {
    case RaceKind::triangulation:
      break;
    case RaceKind::graph:
      return judge_graph(ground_, lap);
    case RaceKind::refinement:
      return judge_refined(ground_, lap);
  }
  return judge_points(ground_, lap, promise);
}

Ruling Referee::judge(Lap lap, Promise promise) {
  if (lap.outcome != Outcome::ok) return {lap.outcome, lap.reason};
  if (lap.triangles.empty()) return {Outcome::refused_input, "the points span no triangle"};
  if (kind_ == RaceKind::refinement) return judge_mesh(lap, promise);
  auto& known = verdicts_[{digest(lap.triangles), promise}];
  if (!known) known = judge_mesh(lap, promise);
  return *known;
}

}  // namespace tribunal::bench
