#include "algorithms/verify/triangles.hpp"

#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>
#include <tuple>

namespace tribunal::verify {
namespace {

using Corners = std::array<std::uint32_t, 3>;

bool in_range(std::uint32_t triangle, const Corners& corners, std::size_t points, FaultList& faults) {
  std::vector<std::uint32_t> outside;
  for (const std::uint32_t corner : corners)
    if (corner >= points) outside.push_back(corner);
  if (outside.empty()) return true;
  faults.add(FaultKind::index_out_of_range, {triangle}, outside, "names a point that is not there");
  return false;
}

Corners by_first_copies(std::uint32_t triangle, const Corners& listed, const Sites& sites,
                        FaultList& faults) {
  Corners corners = listed;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = sites.representative[listed[i]];
    const bool named_before = std::find(listed.begin(), listed.begin() + i, listed[i]) != listed.begin() + i;
    if (corners[i] != listed[i] && !named_before)
      faults.add(FaultKind::duplicate_used, {triangle}, {listed[i], corners[i]},
                 "uses a later copy of a point");
  }
  return corners;
}

bool distinct(std::uint32_t triangle, const Corners& corners, FaultList& faults) {
  for (int i = 0; i < 3; ++i) {
    if (corners[i] != corners[(i + 1) % 3]) continue;
    faults.add(FaultKind::repeated_corner, {triangle}, {corners[i]}, "names one point twice");
    return false;
  }
  return true;
}

Sign check_orientation(std::span<const Point2> points, std::uint32_t triangle, const Corners& corners,
                       FaultList& faults) {
  const Sign sign = orientation(points[corners[0]], points[corners[1]], points[corners[2]]);
  const std::vector<std::uint32_t> named(corners.begin(), corners.end());
  if (sign == Sign::negative) faults.add(FaultKind::wrong_orientation, {triangle}, named, "is clockwise");
  if (sign == Sign::zero) faults.add(FaultKind::flat_triangle, {triangle}, named, "has no area");
  return sign;
}

/// Names triangles with the same corners and leaves out all but the first.
void remove_doubles(std::vector<SoundTriangle>& triangles, FaultList& faults) {
  std::vector<std::pair<Corners, std::uint32_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    Corners corners = triangles[i].corners;
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> is_double(triangles.size());
  std::size_t first = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[first].first) {
      first = i;
      continue;
    }
    is_double[sorted[i].second] = true;
    const Corners& corners = sorted[i].first;
    faults.add(FaultKind::doubled_triangle,
               {triangles[sorted[first].second].index, triangles[sorted[i].second].index},
               {corners.begin(), corners.end()}, "have the same corners");
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!is_double[i]) triangles[kept++] = triangles[i];
  triangles.resize(kept);
}

}  // namespace

std::vector<SoundTriangle> check_triangles(std::span<const Point2> points, const Sites& sites,
                                           const Mesh& mesh, FaultList& faults) {
  std::vector<SoundTriangle> sound;
  sound.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!in_range(i, mesh.triangles[i], points.size(), faults)) continue;
    const Corners corners = by_first_copies(i, mesh.triangles[i], sites, faults);
    if (!distinct(i, corners, faults)) continue;
    sound.push_back({i, corners, check_orientation(points, i, corners, faults)});
  }
  remove_doubles(sound, faults);
  return sound;
}

std::vector<EdgeUse> edge_uses(std::span<const SoundTriangle> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [index, corners, orientation] = triangles[t];
    for (std::uint8_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[(i + 1) % 3], to = corners[(i + 2) % 3];
      const bool upward = (from < to) == (orientation != Sign::negative);
      uses.push_back({std::min(from, to), std::max(from, to), t, i, upward, orientation == Sign::zero});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.sound) < std::tie(b.low, b.high, b.sound);
  });
  return uses;
}

}  // namespace tribunal::verify
