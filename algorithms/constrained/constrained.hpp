// The constrained Delaunay triangulation of a planar straight-line graph.
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "predicates/kernel.hpp"

namespace tribunal {

/// Triangulates the graph's points, inserting them in the order of `order` (a permutation of all indices),
/// brings its segments in and keeps the triangles of its domain. Of all triangulations with the segments as
/// unions of edges it is the one where no circle of a triangle has a vertex inside that can be seen from the
/// triangle past the segments (Chew 1989; Lee and Lin 1986).
///
/// Duplicates are merged; a vertex on a segment splits it; overlapping segments share edges. Two segments
/// that cross inside both are refused: outcome refused_input, `crossing` names them. Points that are
/// collinear are joined by a path, which holds all segments. Never throws for geometric reasons. The kernel
/// must be bound to the points.
///
/// Insertion walks from site to site, so an order that keeps neighbours together (BRIO, Hilbert) makes it
/// O(n) expected on uniform points; then O(degree) for a segment that is an edge, else as its recovery.
ConstrainedTriangulation triangulate_graph(const Graph& graph, std::span<const Index> order,
                                           const Kernel2& kernel, Recovery recovery = Recovery::cavity);

}  // namespace tribunal
