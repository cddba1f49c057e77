// The whole mesh behind a constrained triangulation: what lies outside the domain, ghosts and held edges
// included.
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "algorithms/constrained/mesh.hpp"
#include "algorithms/constrained/recover.hpp"

#include <functional>
#include <span>
#include <vector>

namespace tribunal::constrained {

struct GraphMesh {
  Mesh mesh;
  Recovered recovered;
  std::vector<bool> inside;   ///< of each triangle, whether it belongs to the domain
  std::vector<Index> point;   ///< of each vertex, the graph's point
  std::vector<Index> vertex;  ///< of each of the graph's points, its vertex; of a duplicate that of the first
};

/// Two segments that cross inside both.
struct Crossing : Abandon {
  explicit Crossing(Edge pair)
      : Abandon(Outcome::refused_input,
                "segments " + std::to_string(pair[0]) + " and " + std::to_string(pair[1]) + " cross"),
        segments(pair) {}
  Edge segments;
};

/// Distinct points of a graph in an order of insertion, of which the first three are not collinear if any
/// are not.
struct GraphSites {
  std::vector<Index> order;  ///< the first occurrences
  std::vector<Index> first;  ///< of each point
  bool collinear = false;    ///< all of them
};
/// Throws Abandon where there are none, or too many.
GraphSites distinct_sites(const Graph& graph, std::span<const Index> order, const Kernel2& kernel);

/// Inserts the sites, which are not collinear, brings the segments in and finds the domain. Throws Crossing,
/// NoHole, OpenLoop (which then names the graph's point) and other Abandons.
GraphMesh build_graph_mesh(const Graph& graph, const GraphSites& sites, const Kernel2& kernel,
                           Recovery recovery);

/// Does `work`; where it abandons, the result says why and what was in the way.
void report_refusals(ConstrainedTriangulation& result, const std::function<void()>& work);

}  // namespace tribunal::constrained
