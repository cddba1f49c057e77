// The Hilbert curve: a line through all cells of a square that keeps neighbours together.
#pragma once

#include <cstdint>

namespace tribunal {

/// Position of a cell along the Hilbert curve through the lattice [0, 2^32)^2 (Hilbert 1891): it starts at
/// the cell (0, 0), ends at (2^32 - 1, 0), and each step leads to a cell that shares a side.
std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y);

}  // namespace tribunal
