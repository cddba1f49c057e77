// Which held edges of a mesh are walls, and which ways lead away from them.
#pragma once

#include "algorithms/constrained/mesh.hpp"
#include "algorithms/stretching/segment_tree.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal::stretching {

enum class WallChoice : std::uint8_t {
  inner,  ///< segments that do not hang together with the outer boundary; all, where there are no others
  all,    ///< every segment
};

/// The segments of a confined mesh that touch its domain, walls and others.
struct Boundary {
  std::vector<Segment> walls, rim;
  std::vector<char> on_wall;  ///< of each vertex
};
Boundary boundary_of(const constrained::Mesh& mesh, WallChoice choice);

using Vector = std::array<double, 2>;

/// The unit vectors that lead from a vertex on held edges into the domain: for each sector between two of
/// them the bisector; where the sector is wider than a half plane by 60 degrees or more, the normals of
/// both edges, and their bisector too if they are 120 degrees apart, so that layers go around a sharp edge.
std::vector<Vector> ways_from(const constrained::Mesh& mesh, Index vertex);

}  // namespace tribunal::stretching
