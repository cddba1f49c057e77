#include "bench/judge.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tribunal::bench {
namespace {

using verify::Fault;
using verify::FaultKind;

bool has(std::span<const Fault> faults, FaultKind kind) {
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& f) { return f.kind == kind; });
}

bool only(std::span<const Fault> faults, std::span<const FaultKind> kinds) {
  return std::all_of(faults.begin(), faults.end(), [&](const Fault& f) {
    return std::find(kinds.begin(), kinds.end(), f.kind) != kinds.end();
  });
}

Outcome outcome_of(std::span<const Fault> faults) {
  constexpr std::array delaunay{FaultKind::non_delaunay};
  constexpr std::array missing{FaultKind::missing_site, FaultKind::wrong_count, FaultKind::hull_mismatch,
                               FaultKind::non_delaunay};
  if (faults.empty()) return Outcome::ok;
  if (only(faults, delaunay)) return Outcome::non_delaunay;
  if (has(faults, FaultKind::missing_site) && only(faults, missing)) return Outcome::missing_site;
  return Outcome::invalid_topology;
}

// The checker accepts any set on a line without triangles; the path is this much.
bool path_is_whole(const Triangulation& t, std::uint64_t sites) {
  return t.dimension == 2 || t.edges.size() + 1 == sites;
}

}  // namespace

Judgement judgement_of(const verify::Verdict& verdict) {
  Judgement judgement{outcome_of(verdict.faults), {}, verdict.ties};
  if (verdict.valid()) return judgement;
  const Fault& first = verdict.faults.front();
  const std::string_view kind = verify::to_string(first.kind);
  judgement.reason =
      kind == to_string(judgement.outcome) ? first.detail : std::string(kind) + ": " + first.detail;
  return judgement;
}

Judgement judge(std::span<const Point2> points, const Triangulation& triangulation, Promise promise) {
  const auto kind = promise == Promise::delaunay ? verify::Kind::delaunay : verify::Kind::triangulation;
  const verify::Verdict verdict =
      verify::verify_planar(points, {.triangles = triangulation.triangles}, {.kind = kind});
  Judgement judgement = judgement_of(verdict);
  if (verdict.valid() &&
      (triangulation.dimension != verdict.dimension || !path_is_whole(triangulation, verdict.sites))) {
    judgement.outcome = Outcome::invalid_topology;
    judgement.reason = "dimension " + std::to_string(triangulation.dimension) +
                       " reported, the points have " + std::to_string(verdict.dimension);
  }
  return judgement;
}

}  // namespace tribunal::bench
