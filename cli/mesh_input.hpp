// A user's mesh over a user's points.
#pragma once

#include "datasets/files/files.hpp"

#include <string>

namespace tribunal::cli {

struct MeshInput {
  PointFile points;
  MeshFile mesh;
};

/// Reads both. A mesh file that carries coordinates must carry those of the points: a tool that drops, moves
/// or reorders vertices has triangulated something else. Throws BadInput.
MeshInput read_mesh_over(const std::string& points, const std::string& mesh);

}  // namespace tribunal::cli
