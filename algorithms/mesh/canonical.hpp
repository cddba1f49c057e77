// One spelling for each triangulation, so that two can be compared and hashed.
#pragma once

#include "algorithms/triangulation.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

/// Each triangle rotated to begin with its smallest index (orientation kept), the triangles sorted. O(n log
/// n).
std::vector<Triangle> canonical(std::span<const Triangle> triangles);

/// FNV-1a (64 bits) over the canonical triangles as little-endian 32-bit words: equal meshes, equal digests,
/// on every machine.
std::uint64_t digest(std::span<const Triangle> triangles);

/// The digest as it is printed: 16 hexadecimal digits.
std::string to_hex(std::uint64_t digest);

}  // namespace tribunal
