// When an edge is to be flipped: the policy that a flip engine is given.
#pragma once

#include "algorithms/mesh/edge_mesh.hpp"

#include <concepts>

namespace tribunal {

/// A local criterion.
///
/// improves(mesh, edge): whether flipping this inner edge makes the triangulation strictly better. A total
/// order over triangulations must stand behind it, else flipping may go round in circles. Ties are no
/// improvement.
///
/// implies_convexity: where it improves, the edge's quadrilateral is strictly convex; else the engine asks
/// that first and `improves` may take it for granted.
///
/// reach: 1 when the answer depends on the two triangles of the edge alone, 2 when also on their neighbours.
///
/// A criterion may have a member flipped(mesh, edge), which is told of every flip when it is done: for what
/// it keeps by edge or by triangle.
template <class C>
concept FlipCriterion = requires(C criterion, const EdgeMesh& mesh, Index edge) {
  { criterion.improves(mesh, edge) } -> std::same_as<bool>;
  { C::implies_convexity } -> std::convertible_to<bool>;
  { C::reach } -> std::convertible_to<int>;
};

}  // namespace tribunal
