// What a segment runs through that is not yet in the mesh.
#pragma once

#include "algorithms/constrained/mesh.hpp"

#include <vector>

namespace tribunal::constrained {

/// The part of a segment up to the first vertex on it, and the triangles that this part crosses. Both chains
/// run from its start to its end; side[i] is the half-edge, inside the channel, between chain[i] and chain[i
/// + 1].
struct Channel {
  struct Side {
    std::vector<Index> chain;
    std::vector<HalfEdge> side;
  };
  Index start, end;
  HalfEdge edge =
      PlanarMesh::none;          ///< from start to end, where they are neighbours already: nothing is crossed
  Index blocked_by = free_edge;  ///< the piece that is crossed first; the rest is then incomplete
  std::vector<Index> triangles = {};  ///< in the order in which they are met
  std::vector<Edge> crossed = {};     ///< edges between them, each from the right chain to the left one
  Side left = {}, right = {};
};

/// Follows the segment from vertex a towards vertex b.
Channel trace(const Mesh& mesh, Index a, Index b);

/// Replaces the channel's triangles by constrained Delaunay ones on both sides of the edge start-end (Anglada
/// 1997).
void fill(Mesh& mesh, const Channel& channel);

}  // namespace tribunal::constrained
