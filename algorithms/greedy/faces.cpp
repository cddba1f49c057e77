#include "algorithms/greedy/faces.hpp"

#include "algorithms/greedy/domain.hpp"
#include "algorithms/greedy/radial_order.hpp"

#include <algorithm>

namespace tribunal {
namespace {

/// Both directions of every edge, by start, then counter-clockwise.
std::vector<Edge> sorted_spokes(const PlanarProblem& problem, const std::vector<Edge>& edges) {
  std::vector<Edge> spokes;
  spokes.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    spokes.push_back({a, b});
    spokes.push_back({b, a});
  }
  std::stable_sort(spokes.begin(), spokes.end(), [&](const Edge& s, const Edge& t) {
    if (s[0] != t[0]) return s[0] < t[0];
    return s[1] != t[1] && RadialOrder(problem, s[0])(s[1], t[1]);
  });
  return spokes;
}

}  // namespace

std::vector<Triangle> faces_between(const GreedyProblem& problem, const std::vector<Edge>& edges) {
  const std::vector<Edge> spokes = sorted_spokes(problem.planar, edges);
  const Domain domain(problem);
  const auto& p = problem.planar.points;
  std::vector<Triangle> triangles;
  // In a complete triangulation two neighbouring spokes that turn left span a triangle, unless the wedge
  // between them is outside.
  for (auto first = spokes.begin(); first != spokes.end();) {
    const Index v = (*first)[0];
    const auto last = std::find_if(first, spokes.end(), [v](const Edge& spoke) { return spoke[0] != v; });
    for (auto spoke = first; spoke != last; ++spoke) {
      const Index a = (*spoke)[1], b = (*(spoke + 1 == last ? first : spoke + 1))[1];
      if (v > a || v > b || a == b) continue;
      if (problem.planar.kernel.orient2d(p[v], p[a], p[b]) == Sign::positive && domain.opens_after(v, a))
        triangles.push_back({v, a, b});
    }
    first = last;
  }
  return triangles;
}

}  // namespace tribunal
