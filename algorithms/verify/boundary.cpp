#include "algorithms/verify/boundary.hpp"

#include "algorithms/verify/disjoint_sets.hpp"
#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>

namespace tribunal::verify {
namespace {

constexpr std::uint32_t nowhere = 0xFFFFFFFF;

void name_edge_of_hull(std::uint32_t from, std::uint32_t to, FaultList& faults) {
  faults.add(FaultKind::hull_mismatch, {}, {std::min(from, to), std::max(from, to)},
             "an edge of the convex hull is not on the boundary");
}

/// Edges of the boundary that are not of the hull.
using Strays = std::vector<EdgeUse>;

/// Sorts the strays into components that hang together at vertices.
std::vector<Strays> components(std::size_t points, const Strays& strays) {
  DisjointSets sets(points);
  for (const EdgeUse& stray : strays) sets.unite(stray.low, stray.high);
  std::vector<std::pair<std::uint32_t, std::size_t>> keyed;
  for (std::size_t i = 0; i < strays.size(); ++i) keyed.emplace_back(sets.find(strays[i].low), i);
  std::sort(keyed.begin(), keyed.end());
  std::vector<Strays> groups;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].first != keyed[i - 1].first) groups.emplace_back();
    groups.back().push_back(strays[keyed[i].second]);
  }
  return groups;
}

/// A hole is left where the strays enter each vertex as often as they leave it and run clockwise; around a
/// slit, which a vertex inside an edge makes, they enclose nothing.
bool is_hole(std::span<const Point2> points, const Strays& strays) {
  std::vector<std::uint32_t> sources, targets;
  std::vector<std::array<Point2, 2>> edges;
  for (const EdgeUse& stray : strays) {
    sources.push_back(stray.from());
    targets.push_back(stray.to());
    edges.push_back({points[stray.from()], points[stray.to()]});
  }
  std::sort(sources.begin(), sources.end());
  std::sort(targets.begin(), targets.end());
  return sources == targets && enclosed_area(edges) != Sign::positive;
}

void sort_unique(std::vector<std::uint32_t>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

void name_hole(std::span<const SoundTriangle> triangles, const Strays& strays, FaultList& faults) {
  std::vector<std::uint32_t> rim, corners;
  for (const EdgeUse& stray : strays) {
    rim.push_back(triangles[stray.sound].index);
    corners.push_back(stray.low);
    corners.push_back(stray.high);
  }
  sort_unique(rim);
  sort_unique(corners);
  faults.add(FaultKind::not_connected, rim, corners, "enclose a hole or slit");
}

}  // namespace

void check_boundary(std::span<const Point2> points, std::span<const std::uint32_t> hull,
                    std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                    FaultList& faults) {
  // Edges of the hull still to be found, by where they start.
  std::vector<std::uint32_t> next(points.size(), nowhere);
  for (std::size_t i = 0; i < hull.size(); ++i) next[hull[i]] = hull[(i + 1) % hull.size()];

  Strays strays;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 1) return;
    if (next[edge[0].from()] == edge[0].to())
      next[edge[0].from()] = nowhere;
    else
      strays.push_back(edge[0]);
  });
  for (const std::uint32_t vertex : hull)
    if (next[vertex] != nowhere) name_edge_of_hull(vertex, next[vertex], faults);
  if (strays.empty()) return;

  for (const Strays& component : components(points.size(), strays)) {
    if (is_hole(points, component)) {
      name_hole(triangles, component, faults);
      continue;
    }
    for (const EdgeUse& stray : component)
      faults.add(FaultKind::hull_mismatch, {triangles[stray.sound].index}, {stray.low, stray.high},
                 "an edge of the boundary is not on the convex hull");
  }
}

void check_count(std::uint64_t triangles, std::uint64_t sites, std::uint64_t hull, FaultList& faults) {
  const std::uint64_t expected = 2 * sites - 2 - hull;
  if (triangles == expected) return;
  faults.add(
      FaultKind::wrong_count, {}, {},
      "there are " + std::to_string(triangles) + " triangles, and 2n - 2 - h = " + std::to_string(expected) +
          " for n = " + std::to_string(sites) + " sites, h = " + std::to_string(hull) + " on the hull");
}

}  // namespace tribunal::verify
