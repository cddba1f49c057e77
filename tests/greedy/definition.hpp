// The greedy triangulation by its definition, in 64-bit integers and written unlike the algorithms: an
// accepted edge strikes what it conflicts with off the pool.
#pragma once

#include "algorithms/triangulation.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace tribunal::greedy {

/// A site with coordinates below 2^15 in magnitude.
struct Site {
  std::int64_t x, y;
};
using LatticeSites = std::vector<Site>;

/// Twice the area of abc.
inline std::int64_t area(const Site& a, const Site& b, const Site& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// p on the closed segment ab.
inline bool is_on(const Site& a, const Site& b, const Site& p) {
  return area(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
}

/// Whether two different segments have more in common than an end of both.
inline bool conflict(const LatticeSites& sites, const Edge& e, const Edge& f) {
  const Site &a = sites[e[0]], &b = sites[e[1]], &c = sites[f[0]], &d = sites[f[1]];
  const auto is_end = [](Index v, const Edge& edge) { return v == edge[0] || v == edge[1]; };
  for (const Index v : f)
    if (!is_end(v, e) && is_on(a, b, sites[v])) return true;
  for (const Index v : e)
    if (!is_end(v, f) && is_on(c, d, sites[v])) return true;
  const auto crossed = [](std::int64_t s, std::int64_t t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
  return crossed(area(a, b, c), area(a, b, d)) && crossed(area(c, d, a), area(c, d, b));
}

inline bool meets_a_site(const LatticeSites& sites, const Edge& e) {
  for (Index v = 0; v < sites.size(); ++v)
    if (v != e[0] && v != e[1] && is_on(sites[e[0]], sites[e[1]], sites[v])) return true;
  return false;
}

/// The edges in their order, the given ones first; other candidates must pass `admitted`. No two sites are
/// equal.
inline std::vector<Edge> by_definition(
    const LatticeSites& sites, const std::vector<Edge>& given = {},
    const std::function<bool(const Edge&)>& admitted = [](const Edge&) { return true; }) {
  std::vector<std::tuple<std::int64_t, Edge>> pool;
  for (Index a = 0; a < sites.size(); ++a)
    for (Index b = a + 1; b < sites.size(); ++b) {
      const std::int64_t x = sites[a].x - sites[b].x, y = sites[a].y - sites[b].y;
      if (!meets_a_site(sites, {a, b})) pool.emplace_back(x * x + y * y, Edge{a, b});
    }
  std::sort(pool.begin(), pool.end());
  std::vector<Edge> edges;
  const auto accept = [&](Edge edge) {
    std::sort(edge.begin(), edge.end());
    if (std::find(edges.begin(), edges.end(), edge) != edges.end()) return;
    edges.push_back(edge);
    std::erase_if(pool, [&](const auto& candidate) {
      return std::get<1>(candidate) == edge || conflict(sites, edge, std::get<1>(candidate));
    });
  };
  for (const Edge& edge : given) accept(edge);
  std::erase_if(pool, [&](const auto& candidate) { return !admitted(std::get<1>(candidate)); });
  while (!pool.empty()) accept(std::get<1>(pool.front()));
  return edges;
}

}  // namespace tribunal::greedy
