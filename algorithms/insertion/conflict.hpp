// When a new site destroys a triangle: the one geometric test that all Delaunay insertions share.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

namespace tribunal {

/// A ghost (infinite, u, v) stands for the open half plane left of u -> v, together with the open segment uv:
/// a site there makes the hull edge disappear. A collinear site beyond the segment does not.
inline bool ghost_in_conflict(const PlanarProblem& problem, Index u, Index v, Index site) {
  const auto& p = problem.points;
  const Sign side = problem.kernel.orient2d(p[u], p[v], p[site]);
  return side == Sign::positive || (side == Sign::zero && strictly_between(p[u], p[site], p[v]));
}

/// True when `site` lies strictly inside the circle of the finite triangle abc, or in what the ghost stands
/// for. Ties (a site on the circle) are no conflict.
inline bool in_conflict(const PlanarProblem& problem, const Triangle& t, Index site) {
  for (int i = 0; i < 3; ++i)
    if (t[i] == infinite) return ghost_in_conflict(problem, t[(i + 1) % 3], t[(i + 2) % 3], site);
  const auto& p = problem.points;
  return problem.kernel.incircle(p[t[0]], p[t[1]], p[t[2]], p[site]) == Sign::positive;
}

}  // namespace tribunal
