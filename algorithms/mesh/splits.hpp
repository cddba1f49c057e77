// Splits and flips of a PlanarMesh in place: slots of triangles are used again, none is left dead.
#pragma once

#include "algorithms/mesh/planar_mesh.hpp"

#include <array>

namespace tribunal {

/// Triangle t, or ghost, becomes the star of `site`: t itself and two more.
inline void split_triangle(PlanarMesh& mesh, Index t, Index site) {
  const Triangle corner = mesh.triangle(t);
  const std::array<HalfEdge, 3> beyond{mesh.twin(3 * t), mesh.twin(3 * t + 1), mesh.twin(3 * t + 2)};
  mesh.replace(t, site, corner[1], corner[2]);
  const Triangle child{t, mesh.add(site, corner[2], corner[0]), mesh.add(site, corner[0], corner[1])};
  for (Index i = 0; i < 3; ++i) {
    mesh.glue(3 * child[i], beyond[i]);
    mesh.glue(3 * child[i] + 1, 3 * child[(i + 1) % 3] + 2);
  }
}

/// The two triangles of an edge, one of which may be a ghost, become the four of the star of a site on it.
inline void split_edge(PlanarMesh& mesh, HalfEdge edge, Index site) {
  const HalfEdge twin = mesh.twin(edge);
  const Index t = triangle_of(edge), u = triangle_of(twin);
  const Index a = mesh.from(edge), b = mesh.to(edge), p = mesh.corner(edge), q = mesh.corner(twin);
  const HalfEdge beyond_bp = mesh.twin(next(edge)), beyond_pa = mesh.twin(prev(edge));
  const HalfEdge beyond_aq = mesh.twin(next(twin)), beyond_qb = mesh.twin(prev(twin));
  mesh.replace(t, site, p, a);
  mesh.replace(u, site, q, b);
  const std::array<Index, 4> star{t, mesh.add(site, a, q), u, mesh.add(site, b, p)};  // counter-clockwise
  const std::array<HalfEdge, 4> beyond{beyond_pa, beyond_aq, beyond_qb, beyond_bp};
  for (Index i = 0; i < 4; ++i) {
    mesh.glue(3 * star[i], beyond[i]);
    mesh.glue(3 * star[i] + 1, 3 * star[(i + 1) % 4] + 2);
  }
}

/// The edge of the triangles (p, a, b) and (q, b, a) becomes q -> p, of (p, a, q) and (q, b, p): half-edges
/// next(edge) and next(twin). The half-edges edge, prev(edge), twin and prev(twin) are the four sides then.
inline void flip_edge(PlanarMesh& mesh, HalfEdge edge) {
  const HalfEdge twin = mesh.twin(edge);
  const Index p = mesh.corner(edge), q = mesh.corner(twin);
  const HalfEdge beyond_bp = mesh.twin(next(edge)), beyond_aq = mesh.twin(next(twin));
  mesh.set_corner(prev(edge), q);
  mesh.set_corner(prev(twin), p);
  mesh.glue(edge, beyond_aq);
  mesh.glue(twin, beyond_bp);
  mesh.glue(next(edge), next(twin));
}

}  // namespace tribunal
