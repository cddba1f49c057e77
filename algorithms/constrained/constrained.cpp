#include "algorithms/constrained/constrained.hpp"

#include "algorithms/constrained/graph_mesh.hpp"

#include <algorithm>

namespace tribunal {
namespace {
using constrained::GraphMesh;
using constrained::GraphSites;

void name_duplicates(const GraphSites& sites, Triangulation& result) {
  for (Index v = 0; v < sites.first.size(); ++v)
    if (sites.first[v] != v) result.duplicates.emplace_back(v, sites.first[v]);
}

void collect(const GraphMesh& built, ConstrainedTriangulation& result) {
  const PlanarMesh& t = built.mesh.triangles();
  Triangulation& out = result.mesh;
  for (Index i = 0; i < t.triangles(); ++i) {
    out.hull += t.is_ghost(i);
    if (!built.inside[i]) continue;
    const Triangle v = t.triangle(i);
    out.triangles.push_back({built.point[v[0]], built.point[v[1]], built.point[v[2]]});
  }
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h)
    if (built.mesh.held(h) && h < t.twin(h))
      result.constraints.push_back({built.point[t.from(h)], built.point[t.to(h)]});
  for (const Touch& touch : built.recovered.touches)
    result.touches.push_back({touch.segment, built.point[touch.vertex]});
  result.swaps = built.recovered.swaps;
  out.counters = built.mesh.counters();
}

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
  ConstrainedTriangulation result;
  constrained::report_refusals(result, [&] {
    const GraphSites sites = constrained::distinct_sites(graph, order, kernel);
    name_duplicates(sites, result.mesh);
    if (sites.collinear) {
      connect_collinear(graph, sites.order, result);
      return;
    }
    result.mesh.dimension = 2;
    collect(constrained::build_graph_mesh(graph, sites, kernel, recovery), result);
  });
  return result;
}

}  // namespace tribunal
