// A user's mesh over a user's points.
#pragma once

#include "datasets/files/files.hpp"

#include <string>

namespace tribunal::cli {

/// Reads the mesh over points read from the file of that name. A mesh file that carries coordinates must
/// carry those of the points: a tool that drops, moves or reorders vertices has triangulated something else.
/// Throws BadInput.
MeshFile read_mesh_over(const std::string& name, const PointFile& points, const std::string& mesh);

}  // namespace tribunal::cli
