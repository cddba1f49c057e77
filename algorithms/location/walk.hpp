// Point location by walking through the triangulation.
#pragma once

#include "algorithms/abandon.hpp"
#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

namespace tribunal {

/// Remembering visibility walk (Devillers, Pion, Teillaud 2002) from triangle `start` to one that holds
/// `site`: a finite triangle that contains it (boundary included) or a ghost whose hull edge sees it from
/// strictly outside. In a Delaunay triangulation it visits no triangle twice when the signs are right; the
/// budget is for when they are not. Adds its steps to `steps`.
inline Index walk(const PlanarProblem& problem, const PlanarMesh& mesh, Index start, Index site,
                  std::uint64_t& steps) {
  Budget budget(mesh.triangles(), "walk");
  const auto& p = problem.points;
  Index t = start;
  if (const HalfEdge hull_edge = mesh.ghost_corner(t); hull_edge != PlanarMesh::none)
    t = triangle_of(mesh.twin(hull_edge));
  HalfEdge entered = PlanarMesh::none;
  for (;;) {
    budget.spend();
    ++steps;
    HalfEdge exit = PlanarMesh::none;
    for (HalfEdge h = 3 * t; h < 3 * t + 3 && exit == PlanarMesh::none; ++h)
      if (h != entered && problem.kernel.orient2d(p[mesh.from(h)], p[mesh.to(h)], p[site]) == Sign::negative)
        exit = h;
    if (exit == PlanarMesh::none) return t;
    entered = mesh.twin(exit);
    t = triangle_of(entered);
    if (mesh.is_ghost(t)) return t;
  }
}

}  // namespace tribunal
