#include "algorithms/constrained/constrained.hpp"

#include "algorithms/constrained/domain.hpp"
#include "algorithms/constrained/mesh.hpp"
#include "algorithms/constrained/recover.hpp"
#include "algorithms/duplicates.hpp"

#include <algorithm>
#include <cassert>

namespace tribunal {
namespace {
using constrained::Mesh;
using constrained::Recovered;

/// Distinct points in the order of insertion, and for each of the graph's points its first occurrence.
struct Sites {
  std::vector<Index> order, first;
};

Sites distinct_sites(const Graph& graph, std::span<const Index> order, Triangulation& result) {
  std::vector<Index> first = first_occurrences(graph.points);
  Sites sites;
  sites.order.reserve(graph.points.size());
  std::vector<bool> seen(graph.points.size(), false);
  for (const Index v : order) {
    if (!seen[first[v]]) sites.order.push_back(first[v]);
    seen[first[v]] = true;
  }
  for (Index v = 0; v < first.size(); ++v)
    if (first[v] != v) result.duplicates.emplace_back(v, first[v]);
  sites.first = std::move(first);
  return sites;
}

/// Moves the first site that is not collinear with the two before it to third place; false where there is
/// none.
bool bring_triangle_forward(const Graph& graph, const Kernel2& kernel, Sites& sites) {
  auto& order = sites.order;
  std::size_t third = 2;
  while (third < order.size() && kernel.orient2d(graph.points[order[0]], graph.points[order[1]],
                                                 graph.points[order[third]]) == Sign::zero)
    ++third;
  if (third >= order.size()) return false;
  std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(third),
              order.begin() + static_cast<std::ptrdiff_t>(third) + 1);
  return true;
}

class Run {
 public:
  Run(const Graph& graph, const Kernel2& kernel, const Sites& sites, ConstrainedTriangulation& result)
      : graph_(graph),
        sites_(sites),
        vertex_(graph.points.size()),
        mesh_(kernel, at(0), at(1), at(2)),
        result_(result) {
    mesh_.reserve(sites.order.size());
    for (Index i = 0; i < sites.order.size(); ++i) vertex_[sites.order[i]] = i;
  }

  void run(Recovery recovery) {
    for (std::size_t i = 3; i < sites_.order.size(); ++i) mesh_.insert(at(i));
    for (Index s = 0; s < graph_.segments.size(); ++s) bring_in(s, recovery);
    collect();
  }

 private:
  Point2 at(std::size_t i) const { return graph_.points[sites_.order[i]]; }

  void bring_in(Index segment, Recovery recovery) {
    const auto [a, b] = graph_.segments[segment];
    const auto crossed = recover(mesh_, vertex(a), vertex(b), segment, recovery, recovered_);
    if (!crossed) return;
    result_.crossing = Edge{*crossed, segment};
    throw Abandon(Outcome::refused_input,
                  "segments " + std::to_string(*crossed) + " and " + std::to_string(segment) + " cross");
  }
  Index vertex(Index point) const { return vertex_[sites_.first[point]]; }

  void collect() {
    const PlanarMesh& t = mesh_.triangles();
    const std::vector<bool> inside = domain();
    Triangulation& out = result_.mesh;
    for (Index i = 0; i < t.triangles(); ++i) {
      out.hull += t.is_ghost(i);
      if (!inside[i]) continue;
      const Triangle v = t.triangle(i);
      out.triangles.push_back({sites_.order[v[0]], sites_.order[v[1]], sites_.order[v[2]]});
    }
    for (HalfEdge h = 0; h < 3 * t.triangles(); ++h)
      if (mesh_.held(h) && h < t.twin(h))
        result_.constraints.push_back({sites_.order[t.from(h)], sites_.order[t.to(h)]});
    for (const Touch& touch : recovered_.touches)
      result_.touches.push_back({touch.segment, sites_.order[touch.vertex]});
    result_.swaps = recovered_.swaps;
    out.counters = mesh_.counters();
  }

  std::vector<bool> domain() {
    try {
      return find_domain(mesh_, recovered_, graph_);
    } catch (const constrained::NoHole& error) {
      result_.hole = error.hole;
      throw;
    } catch (const constrained::OpenLoop& error) {
      result_.open_end = sites_.order[error.vertex];
      throw;
    }
  }

  const Graph& graph_;
  const Sites& sites_;
  std::vector<Index> vertex_;  // of each point that is a first occurrence, its number in the mesh
  Mesh mesh_;
  Recovered recovered_;
  ConstrainedTriangulation& result_;
};

/// The path through collinear sites, in lexicographic order, which is the order along their line.
void connect_collinear(const Graph& graph, std::vector<Index> sites, ConstrainedTriangulation& result) {
  std::sort(sites.begin(), sites.end(), [&](Index a, Index b) { return graph.points[a] < graph.points[b]; });
  for (std::size_t i = 1; i < sites.size(); ++i) result.mesh.edges.push_back({sites[i - 1], sites[i]});
  result.mesh.dimension = sites.size() > 1 ? 1 : 0;
  result.mesh.hull = sites.size();
  if (graph.domain != Domain::hull)
    throw Abandon(Outcome::refused_input, "all points lie on one line: the segments enclose nothing");
}

}  // namespace

ConstrainedTriangulation triangulate_graph(const Graph& graph, std::span<const Index> order,
                                           const Kernel2& kernel, Recovery recovery) {
  assert(order.size() == graph.points.size());
  ConstrainedTriangulation result;
  try {
    if (graph.points.empty()) throw Abandon(Outcome::refused_input, "there are no points");
    if (graph.points.size() >= 0xFFFFFFFF / 6)
      throw Abandon(Outcome::refused_input, "more points than 32-bit indices can serve");
    Sites sites = distinct_sites(graph, order, result.mesh);
    if (!bring_triangle_forward(graph, kernel, sites)) {
      connect_collinear(graph, std::move(sites.order), result);
      return result;
    }
    result.mesh.dimension = 2;
    Run(graph, kernel, sites, result).run(recovery);
  } catch (const Abandon& abandon) {
    result.mesh.outcome = abandon.outcome;
    result.mesh.reason = abandon.what();
  }
  return result;
}

}  // namespace tribunal
