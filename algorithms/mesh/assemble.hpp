// From triangles to a mesh that knows its neighbours.
#pragma once

#include "algorithms/mesh/planar_mesh.hpp"

#include <span>

namespace tribunal {

/// The mesh of the counter-clockwise triangles of a triangulation whose outer boundary is one simple cycle,
/// in their order, with a ghost on each hull edge behind them. O(m log m). Abandons (inconsistent_predicate)
/// where the triangles do not fit together so.
PlanarMesh assemble(std::span<const Triangle> triangles);

}  // namespace tribunal
