// A mesh as a picture.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

namespace tribunal {

/// Draws the mesh to an .svg file, y upwards, the longer side of its box 1000 units wide. Throws BadInput
/// when the file cannot be written or its ending is another.
void write_picture(const std::filesystem::path& path, std::span<const Point2> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace tribunal
