// The signs a backend gives on a grid of points, as a picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::reports {

/// What is to be seen at one grid point. The last three are wrong signs.
enum class Pixel : std::uint8_t { positive, negative, zero, false_zero, inverted, false_nonzero };

inline constexpr std::size_t pixel_kinds = 6;

/// Red, green, blue of each kind: right signs pale, wrong ones strong.
inline constexpr std::array<std::array<std::uint8_t, 3>, pixel_kinds> pixel_colours{{
    {207, 226, 243},
    {252, 229, 205},
    {90, 90, 96},
    {204, 51, 17},
    {0, 0, 0},
    {0, 153, 136},
}};

struct SignMap {
  std::size_t side = 0;
  std::vector<Pixel> pixels;  ///< row by row, y = 0 first
};

/// Compares two run-length texts "+[12]0[3]-[241]..." of equally many signs, a square number of them. Nothing
/// where they are malformed.
std::optional<SignMap> sign_map(std::string_view signs, std::string_view exact);

/// The map as a PNG file, y upwards, one palette entry per kind. Same map, same bytes (for one version of
/// libpng).
std::string png(const SignMap& map);

/// Bytes as base64 (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace tribunal::reports
