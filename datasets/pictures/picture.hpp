// A mesh as a picture.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace tribunal {

enum class Colouring : std::uint8_t {
  plain,
  largest_angle,   ///< of each triangle, from 60 to 180 degrees
  smallest_angle,  ///< of each triangle, from 60 down to 0 degrees
  field,           ///< bands of the field's linear interpolant, from its least to its greatest value
};

struct PictureStyle {
  Colouring colouring = Colouring::plain;
  std::span<const double> field = {};  ///< finite values by point, for its colours and contours; else empty
  std::uint32_t contours = 0;          ///< lines of the linear interpolant, at equal steps of the field
  std::optional<std::array<Point2, 2>> window = {};  ///< lower left and upper right corner of what is shown
};

/// Throws BadInput when the ending is neither .svg nor .png, so that a command can refuse before it computes.
void require_picture_ending(const std::filesystem::path& path);

/// Draws the mesh to a file, y upwards, the longer side of its box or window 1000 units (.svg) or 1200 pixels
/// (.png) wide, and `strokes`, pairs of points, darker over it. Throws BadInput when the file cannot be
/// written or its ending is another.
void write_picture(const std::filesystem::path& path, std::span<const Point2> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::span<const std::array<std::uint32_t, 2>> strokes = {},
                   const PictureStyle& style = {});

}  // namespace tribunal
