// What the shipped real data hold besides points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal {

/// The 847 segments of the dataset `coast`, as pairs of indices into its 850 points, smaller index first.
std::vector<std::array<std::uint32_t, 2>> coast_segments();

}  // namespace tribunal
