#include "tests/faults/naive_checker.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tribunal::faults {
namespace {

using verify::FaultKind;
using Points = std::vector<LatticePoint>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// A triangle that is fit for comparison with others: corners by first copies, counter-clockwise unless flat.
struct Turned {
  std::uint32_t index;
  Triangle corners;
  bool flat;
};

std::uint32_t first_copy(const Points& points, std::uint32_t i) {
  return static_cast<std::uint32_t>(std::find(points.begin(), points.end(), points[i]) - points.begin());
}

std::vector<std::uint32_t> list(const Triangle& corners) { return {corners.begin(), corners.end()}; }

/// The faults of single triangles and of doubles; returns the triangles that are left.
std::vector<Turned> sift(const Points& points, const std::vector<Triangle>& triangles,
                         std::set<Finding>& found) {
  std::vector<Turned> left;
  std::map<std::vector<std::uint32_t>, std::uint32_t> seen;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    Triangle corners = triangles[t];
    std::vector<std::uint32_t> outside;
    std::copy_if(corners.begin(), corners.end(), std::back_inserter(outside),
                 [&](std::uint32_t c) { return c >= points.size(); });
    if (!outside.empty()) {
      found.insert(finding(FaultKind::index_out_of_range, {t}, outside));
      continue;
    }
    for (std::uint32_t& c : corners) {
      const std::uint32_t first = first_copy(points, c);
      if (first != c) found.insert(finding(FaultKind::duplicate_used, {t}, {c, first}));
      c = first;
    }
    std::vector<std::uint32_t> sorted = list(corners);
    std::sort(sorted.begin(), sorted.end());
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    if (repeated != sorted.end()) {
      found.insert(finding(FaultKind::repeated_corner, {t}, {*repeated}));
      continue;
    }
    const Wide turn = area(points[corners[0]], points[corners[1]], points[corners[2]]);
    if (turn < 0) found.insert(finding(FaultKind::wrong_orientation, {t}, sorted));
    if (turn == 0) found.insert(finding(FaultKind::flat_triangle, {t}, sorted));
    const auto [first, fresh] = seen.emplace(sorted, t);
    if (!fresh) {
      found.insert(finding(FaultKind::doubled_triangle, {first->second, t}, sorted));
      continue;
    }
    if (turn < 0) std::swap(corners[1], corners[2]);
    left.push_back({t, corners, turn == 0});
  }
  return left;
}

struct Use {
  const Turned* triangle;
  std::uint32_t apex;
};

std::map<Edge, std::vector<Use>> edges_of(const std::vector<Turned>& triangles) {
  std::map<Edge, std::vector<Use>> edges;
  for (const Turned& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges[std::minmax(t.corners[i], t.corners[(i + 1) % 3])].push_back({&t, t.corners[(i + 2) % 3]});
  return edges;
}

void find_edge_faults(const Points& points, const std::vector<Turned>& triangles, std::set<Finding>& found) {
  for (const auto& [edge, uses] : edges_of(triangles)) {
    if (uses.size() > 2) {
      std::vector<std::uint32_t> around;
      for (const Use& use : uses) around.push_back(use.triangle->index);
      found.insert(finding(FaultKind::non_manifold_edge, around, {edge.first, edge.second}));
    }
    if (uses.size() != 2 || uses[0].triangle->flat || uses[1].triangle->flat) continue;
    const LatticePoint a = points[edge.first], b = points[edge.second];
    const std::vector<std::uint32_t> both{uses[0].triangle->index, uses[1].triangle->index};
    if ((area(a, b, points[uses[0].apex]) > 0) == (area(a, b, points[uses[1].apex]) > 0)) {
      found.insert(finding(FaultKind::folded_edge, both, {edge.first, edge.second}));
      continue;
    }
    const Triangle& t = uses[0].triangle->corners;
    if (in_circle(points[t[0]], points[t[1]], points[t[2]], points[uses[1].apex]) > 0)
      found.insert(
          finding(FaultKind::non_delaunay, both, {edge.first, edge.second, uses[0].apex, uses[1].apex}));
  }
}

void find_missing_sites(const Points& points, const std::vector<Turned>& triangles,
                        std::set<Finding>& found) {
  std::set<std::uint32_t> used;
  for (const Turned& t : triangles) used.insert(t.corners.begin(), t.corners.end());
  for (const std::uint32_t site : distinct_sites(points))
    if (!used.contains(site)) found.insert(finding(FaultKind::missing_site, {}, {site}));
}

/// Sites on the boundary of the hull: those through which a line leaves all others on one side.
std::uint64_t count_hull(const Points& points) {
  const std::vector<std::uint32_t> sites = distinct_sites(points);
  std::uint64_t hull = 0;
  for (const std::uint32_t p : sites)
    hull += std::any_of(sites.begin(), sites.end(),
                        [&](std::uint32_t q) {
                          return q != p && std::all_of(sites.begin(), sites.end(), [&](std::uint32_t r) {
                                   return area(points[p], points[q], points[r]) >= 0;
                                 });
                        }) ||
            std::any_of(sites.begin(), sites.end(), [&](std::uint32_t q) {
              return q != p && std::all_of(sites.begin(), sites.end(), [&](std::uint32_t r) {
                       return area(points[p], points[q], points[r]) <= 0;
                     });
            });
  return hull;
}

std::vector<Turned> with_area(const Points& points, const std::vector<Triangle>& triangles) {
  std::set<Finding> ignored;
  std::vector<Turned> left = sift(points, triangles, ignored);
  std::erase_if(left, [](const Turned& t) { return t.flat; });
  return left;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Finding& finding) {
  out << verify::to_string(finding.kind) << " triangles";
  for (const std::uint32_t t : finding.triangles) out << ' ' << t;
  out << " points";
  for (const std::uint32_t p : finding.points) out << ' ' << p;
  return out;
}

Finding finding(FaultKind kind, std::vector<std::uint32_t> triangles, std::vector<std::uint32_t> points) {
  std::sort(triangles.begin(), triangles.end());
  std::sort(points.begin(), points.end());
  return {kind, std::move(triangles), std::move(points)};
}

Finding finding(const verify::Fault& fault) { return finding(fault.kind, fault.simplices, fault.points); }

const std::set<FaultKind>& naive_kinds() {
  static const std::set<FaultKind> kinds{
      FaultKind::index_out_of_range, FaultKind::repeated_corner, FaultKind::duplicate_used,
      FaultKind::wrong_orientation,  FaultKind::flat_triangle,   FaultKind::doubled_triangle,
      FaultKind::non_manifold_edge,  FaultKind::folded_edge,     FaultKind::missing_site,
      FaultKind::wrong_count,        FaultKind::non_delaunay};
  return kinds;
}

std::set<Finding> naive_findings(const Points& points, const std::vector<Triangle>& triangles) {
  std::set<Finding> found;
  const std::vector<Turned> left = sift(points, triangles, found);
  find_edge_faults(points, left, found);
  find_missing_sites(points, left, found);
  if (triangles.size() != 2 * distinct_sites(points).size() - 2 - count_hull(points))
    found.insert(finding(FaultKind::wrong_count, {}, {}));
  return found;
}

bool naive_overlap(const Points& points, const std::vector<Triangle>& triangles) {
  const std::vector<Turned> turned = with_area(points, triangles);
  const auto edges = edges_of(turned);
  for (const auto& [e, e_uses] : edges)
    for (const auto& [f, f_uses] : edges) {
      const LatticePoint a = points[e.first], b = points[e.second], c = points[f.first], d = points[f.second];
      if (cross_properly(a, b, c, d) || inside_segment(a, b, c) || inside_segment(a, b, d)) return true;
    }
  for (const Turned& t : turned)
    for (const auto& [e, uses] : edges)
      for (const std::uint32_t q : {e.first, e.second})
        if (inside_triangle(points[t.corners[0]], points[t.corners[1]], points[t.corners[2]], points[q]))
          return true;
  return false;
}

bool is_overlap(const Points& points, const std::vector<std::uint32_t>& named) {
  const auto p = [&](std::size_t i) { return points[named[i]]; };
  if (named.size() == 3) return inside_segment(p(1), p(2), p(0));
  return named.size() == 4 &&
         (cross_properly(p(0), p(1), p(2), p(3)) || inside_triangle(p(1), p(2), p(3), p(0)));
}

}  // namespace tribunal::faults
