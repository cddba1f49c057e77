#include "algorithms/constrained/graph_mesh.hpp"

#include "algorithms/constrained/domain.hpp"
#include "algorithms/duplicates.hpp"

#include <algorithm>
#include <cassert>

namespace tribunal::constrained {
namespace {

/// Moves the first site that is not collinear with the two before it to third place.
void bring_triangle_forward(const Graph& graph, const Kernel2& kernel, GraphSites& sites) {
  auto& order = sites.order;
  std::size_t third = 2;
  while (third < order.size() && kernel.orient2d(graph.points[order[0]], graph.points[order[1]],
                                                 graph.points[order[third]]) == Sign::zero)
    ++third;
  sites.collinear = third >= order.size();
  if (sites.collinear) return;
  std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(third),
              order.begin() + static_cast<std::ptrdiff_t>(third) + 1);
}

Mesh insert_sites(const Graph& graph, const GraphSites& sites, const Kernel2& kernel) {
  const auto at = [&](std::size_t i) { return graph.points[sites.order[i]]; };
  Mesh mesh(kernel, at(0), at(1), at(2));
  mesh.reserve(sites.order.size());
  for (std::size_t i = 3; i < sites.order.size(); ++i) mesh.insert(at(i));
  return mesh;
}

void bring_in(const Graph& graph, Recovery recovery, GraphMesh& built) {
  for (Index s = 0; s < graph.segments.size(); ++s) {
    const auto [a, b] = graph.segments[s];
    const auto crossed = recover(built.mesh, built.vertex[a], built.vertex[b], s, recovery, built.recovered);
    if (crossed) throw Crossing({*crossed, s});
  }
}

}  // namespace

GraphSites distinct_sites(const Graph& graph, std::span<const Index> order, const Kernel2& kernel) {
  assert(order.size() == graph.points.size());
  if (graph.points.empty()) throw Abandon(Outcome::refused_input, "there are no points");
  if (graph.points.size() >= 0xFFFFFFFF / 6)
    throw Abandon(Outcome::refused_input, "more points than 32-bit indices can serve");
  GraphSites sites;
  sites.first = first_occurrences(graph.points);
  sites.order.reserve(graph.points.size());
  std::vector<bool> seen(graph.points.size(), false);
  for (const Index v : order) {
    if (!seen[sites.first[v]]) sites.order.push_back(sites.first[v]);
    seen[sites.first[v]] = true;
  }
  bring_triangle_forward(graph, kernel, sites);
  return sites;
}

GraphMesh build_graph_mesh(const Graph& graph, const GraphSites& sites, const Kernel2& kernel,
                           Recovery recovery) {
  assert(!sites.collinear);
  GraphMesh built{insert_sites(graph, sites, kernel), {}, {}, sites.order, sites.first};
  std::vector<Index> number(graph.points.size(), 0);
  for (Index i = 0; i < sites.order.size(); ++i) number[sites.order[i]] = i;
  for (Index& vertex : built.vertex) vertex = number[vertex];
  bring_in(graph, recovery, built);
  try {
    built.inside = find_domain(built.mesh, built.recovered, graph);
  } catch (const OpenLoop& error) {
    Index first = sites.order[error.ends[0]];
    for (const Index end : error.ends) first = std::min(first, sites.order[end]);
    throw OpenLoop({first});
  }
  return built;
}

void report_refusals(ConstrainedTriangulation& result, const std::function<void()>& work) {
  const auto refuse = [&](const Abandon& abandon) {
    result.mesh.outcome = abandon.outcome;
    result.mesh.reason = abandon.what();
  };
  try {
    work();
  } catch (const Crossing& error) {
    result.crossing = error.segments;
    refuse(error);
  } catch (const NoHole& error) {
    result.hole = error.hole;
    refuse(error);
  } catch (const OpenLoop& error) {
    result.open_end = error.ends[0];
    refuse(error);
  } catch (const Abandon& error) {
    refuse(error);
  }
}

}  // namespace tribunal::constrained
