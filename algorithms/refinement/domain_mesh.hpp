// What refinement begins with: the mesh of a graph's domain, its boundary held.
#pragma once

#include "algorithms/constrained/graph_mesh.hpp"

#include <span>

namespace tribunal::refinement {

/// Stands for the segment of an edge that bounds the domain and lies on none, as on a hull.
inline constexpr Index no_segment = 0xFFFFFFFF;

/// The constrained Delaunay mesh of a graph, confined to its domain. Every edge that bounds the domain is
/// held, for it must stop looks and swaps; what lies on no segment is a piece of its own, in a run of
/// `no_segment`. Throws Abandon where all points lie on one line or no domain is left, and what
/// `build_graph_mesh` throws.
constrained::GraphMesh build_domain_mesh(const Graph& graph, std::span<const Index> order,
                                         const Kernel2& kernel);

}  // namespace tribunal::refinement
