// Getting the segments of a planar straight-line graph into a triangulation of its vertices.
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "algorithms/constrained/mesh.hpp"

#include <optional>
#include <vector>

namespace tribunal::constrained {

/// A part of a segment that is one edge of the mesh. Overlapping segments share it.
struct Piece {
  Index segment;       ///< the first of them
  Index segments = 1;  ///< how many
};

/// The segments that are in a mesh: pieces as the mesh's edges name them, and what happened on the way.
struct Recovered {
  std::vector<Piece> pieces;
  std::vector<std::array<Index, 2>> runs;  ///< (segment, piece): the pieces of each segment, from its start
  std::vector<Touch> touches;              ///< vertices by their number in the mesh
  std::uint64_t swaps = 0;
};

/// Makes the segment from vertex a to vertex b a union of held edges, in a mesh that is constrained Delaunay
/// before and after. Gives the segment that it crosses, if it crosses one; the mesh is then valid, and holds
/// part of the segment. Degenerate segments (a == b) are nothing. Work in proportion to the edges crossed
/// where they are few; swaps may take their square.
std::optional<Index> recover(Mesh& mesh, Index a, Index b, Index segment, Recovery recovery,
                             Recovered& recovered);

}  // namespace tribunal::constrained
