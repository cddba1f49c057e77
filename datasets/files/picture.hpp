// A mesh as a picture.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

namespace tribunal {

/// Throws BadInput when the ending is not .svg, so that a command can refuse before it computes.
void require_picture_ending(const std::filesystem::path& path);

/// Draws the mesh to an .svg file, y upwards, the longer side of its box 1000 units wide, and `strokes`,
/// pairs of points, darker over it. Throws BadInput when the file cannot be written or its ending is another.
void write_picture(const std::filesystem::path& path, std::span<const Point2> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::span<const std::array<std::uint32_t, 2>> strokes = {});

}  // namespace tribunal
