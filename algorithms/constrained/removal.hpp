// Taking a vertex out of a triangulation with held edges.
#pragma once

#include "algorithms/constrained/mesh.hpp"

#include <vector>

namespace tribunal::constrained {

/// Removes a vertex that no held edge and no ghost touches, and fills its star with triangles that make the
/// mesh constrained Delaunay if it was. Returns their places. The vertex keeps its number, which is no longer
/// a corner of anything. O(degree^2) at worst.
///
/// Swaps take edges from the vertex until three are left, or four in two straight lines: while there are
/// more, one of them is a diagonal of a strictly convex quadrilateral. (Every triangulation of the star's
/// polygon has two ears, and a closed ear that does not hold the vertex can be swapped off; both ears hold it
/// only where it lies on their common side, and the polygon is a quadrilateral.)
std::vector<Index> remove(Mesh& mesh, Index vertex);

}  // namespace tribunal::constrained
