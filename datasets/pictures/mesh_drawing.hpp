// A triangulation as a drawing.
#pragma once

#include "datasets/pictures/drawing.hpp"
#include "datasets/pictures/picture.hpp"

namespace tribunal::pictures {

struct MeshView {
  std::span<const Point2> points;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const std::array<std::uint32_t, 2>> marked;  ///< pairs of points whose connections stand out
};

/// The mesh on a sheet whose longer side is 1000 units: its triangles by the style, their edges, contours,
/// marked edges and, where colours mean something, their scale at the right. Points where there is no
/// triangle. O(n log n), and the bands that each triangle reaches.
Drawing draw(const MeshView& mesh, const PictureStyle& style);

}  // namespace tribunal::pictures
