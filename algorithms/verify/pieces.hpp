// Segments against the edges of a mesh.
#pragma once

#include "algorithms/verify/triangles.hpp"

#include <vector>

namespace tribunal::verify {

/// A stretch of segments from one site to the next on them.
struct Piece {
  std::uint32_t low, high;     ///< the ends
  std::uint32_t segments = 0;  ///< how many segments run over it
  bool on_mesh = false;        ///< it is an edge of the mesh
  /// A triangle lies on the left of low -> high, and of high -> low.
  bool left_covered = false, right_covered = false;
};

/// Follows each segment along the edges of the mesh. Where it leaves them it must stay outside all triangles,
/// and not `everywhere` be held; else it is named. Returns the pieces, each once, sorted by their ends. Two
/// triangles never overlap, and no vertex lies inside an edge.
std::vector<Piece> follow_segments(std::span<const Point2> points, const Sites& sites,
                                   std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                                   const Segments& segments, FaultList& faults);

}  // namespace tribunal::verify
