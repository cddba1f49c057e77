// The two triangles of an inner edge, and what a flip of it touches.
#pragma once

#include "algorithms/flips/sites.hpp"
#include "algorithms/mesh/edge_mesh.hpp"

namespace tribunal {

/// The triangles (from, to, left) and (to, from, right) of an edge; a flip makes (right, left, from) and
/// (left, right, to) of them, and right -> left of the edge.
struct Quadrilateral {
  Index from, to, left, right;
};

inline Quadrilateral quadrilateral(const EdgeMesh& mesh, Index edge) {
  const HalfEdge h = 2 * edge;
  return {mesh.from(h), mesh.to(h), mesh.apex(h), mesh.apex(EdgeMesh::twin(h))};
}

/// Whether the flipped edge would lie inside the quadrilateral, its triangles having area.
inline bool is_strictly_convex(const Sites& sites, const Quadrilateral& q) {
  return sites.orient(q.right, q.left, q.from) == Sign::positive &&
         sites.orient(q.left, q.right, q.to) == Sign::positive;
}

/// Visits the edges whose flips look at a triangle that a flip of `edge` made: its four sides. With a reach
/// of 2 also the far sides of the triangles across these, for criteria that look at neighbours of the two
/// triangles. An edge may be visited twice.
template <int reach>
void visit_suspects(const EdgeMesh& mesh, Index edge, auto visit) {
  static_assert(reach == 1 || reach == 2);
  for (const HalfEdge h : {2 * edge, 2 * edge + 1})
    for (const HalfEdge side : {mesh.next(h), mesh.prev(h)}) {
      visit(EdgeMesh::edge_of(side));
      if constexpr (reach == 2) {
        const HalfEdge across = EdgeMesh::twin(side);
        if (mesh.is_outer(across)) continue;
        visit(EdgeMesh::edge_of(mesh.next(across)));
        visit(EdgeMesh::edge_of(mesh.prev(across)));
      }
    }
}

}  // namespace tribunal
