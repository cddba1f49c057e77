// Measures of triangles beyond size and shape.
#pragma once

#include "algorithms/refinement/steiner_mesh.hpp"

namespace tribunal::refinement {

/// What a triangle of a mesh in the making may fail, too. It must pass when it is small enough.
class TriangleMeasure {
 public:
  virtual ~TriangleMeasure() = default;
  virtual bool fails(const SteinerMesh& mesh, Index t) = 0;
};

}  // namespace tribunal::refinement
