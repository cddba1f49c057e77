#include "algorithms/refinement/domain_mesh.hpp"

#include <algorithm>

namespace tribunal::refinement {
namespace {

void hold_boundary(constrained::GraphMesh& built) {
  constrained::Mesh& mesh = built.mesh;
  const PlanarMesh& t = mesh.triangles();
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h) {
    if (mesh.held(h) || !mesh.inside(triangle_of(h)) || mesh.inside(triangle_of(t.twin(h)))) continue;
    const auto piece = static_cast<Index>(built.recovered.pieces.size());
    mesh.hold(h, piece);
    built.recovered.pieces.push_back({no_segment});
    built.recovered.runs.push_back({no_segment, piece});
  }
}

}  // namespace

constrained::GraphMesh build_domain_mesh(const Graph& graph, std::span<const Index> order,
                                         const Kernel2& kernel) {
  const constrained::GraphSites sites = constrained::distinct_sites(graph, order, kernel);
  if (sites.collinear)
    throw Abandon(Outcome::refused_input, "all points lie on one line: there is nothing to refine");
  constrained::GraphMesh built = build_graph_mesh(graph, sites, kernel, Recovery::cavity);
  if (std::find(built.inside.begin(), built.inside.end(), true) == built.inside.end())
    throw Abandon(Outcome::refused_input, "the holes leave no domain");
  built.mesh.confine({built.inside.begin(), built.inside.end()});
  hold_boundary(built);
  return built;
}

}  // namespace tribunal::refinement
