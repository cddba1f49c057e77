// Every triangulation of a small point set.
#pragma once

#include "algorithms/flips/quadrilateral.hpp"
#include "algorithms/mesh/canonical.hpp"

#include <set>
#include <vector>

namespace tribunal::bench {

/// Visits all triangulations of the points, each once, as canonical triangles: from `first`, any one, flips
/// lead to all others (Lawson 1972). There are exponentially many.
void visit_all_triangulations(const Sites& sites, const std::vector<Triangle>& first, auto visit) {
  std::set<std::vector<Triangle>> seen{canonical(first)};
  std::vector<std::vector<Triangle>> waiting{canonical(first)};
  while (!waiting.empty()) {
    EdgeMesh mesh(waiting.back());
    visit(waiting.back());
    waiting.pop_back();
    for (Index edge = 0; edge < mesh.edges(); ++edge) {
      if (!mesh.is_inner(edge) || !is_strictly_convex(sites, quadrilateral(mesh, edge))) continue;
      mesh.flip(edge);
      if (auto next = canonical(mesh.triangles()); seen.insert(next).second) waiting.push_back(next);
      mesh.flip(edge);
    }
  }
}

}  // namespace tribunal::bench
