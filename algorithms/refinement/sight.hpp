// Looking from a triangle towards a point, past free edges.
#pragma once

#include "algorithms/constrained/mesh.hpp"

#include <cstdint>

namespace tribunal::refinement {

/// Where a look ends.
struct Sighting {
  enum class Kind : std::uint8_t {
    inside,     ///< strictly inside the triangle of `at`
    on_edge,    ///< on the edge `at`, between its ends
    at_vertex,  ///< at the vertex opposite `at`
    blocked,    ///< behind the held edge `at`, seen from the side where the look began
  };
  Kind kind;
  HalfEdge at;
};

/// Walks straight from triangle t, in the domain of a confined mesh, to the triangle that holds p, and stops
/// at the first held edge in the way (Barth section 3.5, step 4). A straight line that passes exactly through
/// a vertex passes it on the left. By signs alone; each triangle is met once, and adds one to `steps`.
Sighting look(const constrained::Mesh& mesh, Index t, Point2 p, std::uint64_t& steps);

}  // namespace tribunal::refinement
