// Islands that reduction has pushed into others, found exactly.
#include "datasets/external/shore.hpp"
#include "datasets/files/files.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

namespace tribunal::shores {
namespace {

int sign(Wide value) { return (value > 0) - (value < 0); }

struct Edge {
  Place a, b;  // a < b
  std::size_t shore;
};

std::vector<Edge> edges_of(const std::vector<Shore>& shores) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < shores.size(); ++i) {
    const std::vector<Place>& places = shores[i].places;
    for (std::size_t k = shores[i].closed ? 0 : 1; k < places.size(); ++k) {
      const Place &p = places[k], &q = places[(k + places.size() - 1) % places.size()];
      edges.push_back({std::min(p, q), std::max(p, q), i});
    }
  }
  std::ranges::sort(edges, [](const Edge& e, const Edge& f) {
    return std::tie(e.a, e.b, e.shore) < std::tie(f.a, f.b, f.shore);
  });
  return edges;
}

/// Edges with a common end meet when they overlap.
bool overlap_beyond(const Place& common, const Place& p, const Place& q) {
  return turn(common, p, q) == 0 &&
         Wide{p.x - common.x} * (q.x - common.x) + Wide{p.y - common.y} * (q.y - common.y) > 0;
}

/// Elsewhere than in a common end.
bool meet(const Edge& e, const Edge& f) {
  const auto [e_low, e_high] = std::minmax(e.a.y, e.b.y);
  const auto [f_low, f_high] = std::minmax(f.a.y, f.b.y);
  if (e_high < f_low || f_high < e_low || e.b.x < f.a.x || f.b.x < e.a.x) return false;
  if (e.a == f.a) return overlap_beyond(e.a, e.b, f.b);
  if (e.b == f.b) return overlap_beyond(e.b, e.a, f.a);
  if (e.a == f.b) return overlap_beyond(e.a, e.b, f.a);
  if (e.b == f.a) return overlap_beyond(e.b, e.a, f.b);
  return turn(e.a, e.b, f.a) * turn(e.a, e.b, f.b) <= 0 && turn(f.a, f.b, e.a) * turn(f.a, f.b, e.b) <= 0;
}

/// The island to take away; nothing where neither is one.
std::optional<std::size_t> smaller_island(const std::vector<Shore>& shores, std::size_t i, std::size_t j) {
  if (!shores[i].closed) std::swap(i, j);
  if (!shores[i].closed) return std::nullopt;
  return shores[j].closed && shores[j].polygon > shores[i].polygon ? j : i;
}

}  // namespace

int turn(const Place& a, const Place& b, const Place& c) {
  return sign(Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x));
}

std::size_t remove_meeting_islands(std::vector<Shore>& shores) {
  const std::vector<Edge> edges = edges_of(shores);
  std::vector<bool> removed(shores.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].a.x <= edges[i].b.x; ++j) {
      const std::size_t s = edges[i].shore, t = edges[j].shore;
      if (removed[s] || removed[t] || !meet(edges[i], edges[j])) continue;
      const auto island = smaller_island(shores, s, t);
      if (!island)
        throw BadInput("shores of polygons " + std::to_string(shores[s].polygon) + " and " +
                       std::to_string(shores[t].polygon) + " cross");
      removed[*island] = true;
    }
  std::size_t at = 0;
  return std::erase_if(shores, [&](const Shore&) { return removed[at++]; });
}

std::array<Place, 4> around_inner_point(const std::vector<Place>& polygon) {
  const std::size_t n = polygon.size();
  const auto i = static_cast<std::size_t>(std::ranges::min_element(polygon) - polygon.begin());
  // The least place is a strict corner; what else lies in its triangle hides the opposite side from it.
  const Place p = polygon[i];
  Place q = polygon[(i + 1) % n], r = polygon[(i + n - 1) % n];
  if (turn(p, q, r) < 0) std::swap(q, r);
  const auto away = [&](const Place& v) {
    return Wide{r.x - q.x} * (v.y - q.y) - Wide{r.y - q.y} * (v.x - q.x);
  };
  const Place* nearest = nullptr;
  for (const Place& v : polygon) {
    if (v == p || v == q || v == r) continue;
    if (turn(p, q, v) < 0 || turn(q, r, v) < 0 || turn(r, p, v) < 0) continue;
    if (nearest == nullptr || away(v) > away(*nearest)) nearest = &v;
  }
  return nearest == nullptr ? std::array{p, p, q, r} : std::array{p, p, *nearest, *nearest};
}

}  // namespace tribunal::shores
