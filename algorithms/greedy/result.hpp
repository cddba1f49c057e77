// A greedy triangulation as users get it.
#pragma once

#include "algorithms/greedy/faces.hpp"
#include "algorithms/greedy/problem.hpp"

namespace tribunal {

/// The triangulation of the convex hull that these edges are, counters included.
inline Triangulation greedy_result(const PlanarProblem& problem, const GreedyEdges& found) {
  Triangulation result;
  result.triangles = faces_between({problem}, found.edges);
  // Every triangle has three edges, and an edge two triangles but on the hull.
  result.hull = 2 * found.edges.size() - 3 * result.triangles.size();
  result.counters.conflict_tests = found.conflict_tests;
  result.counters.location_steps = found.search_steps;
  return result;
}

}  // namespace tribunal
