// From a mesh with ghosts to the arrays that users get.
#pragma once

#include "algorithms/mesh/planar_mesh.hpp"

namespace tribunal {

/// Files triangle t of the final mesh under its kind: finite ones are the result, ghosts count the hull.
inline void collect(const Triangle& t, Triangulation& result) {
  const bool ghost = t[0] == infinite || t[1] == infinite || t[2] == infinite;
  if (ghost)
    ++result.hull;
  else
    result.triangles.push_back(t);
}

}  // namespace tribunal
