// The empty-circle test, edge by edge.
#pragma once

#include "algorithms/verify/triangles.hpp"

namespace tribunal::verify {

/// Names each edge, but for those `held` (ends in ascending order, sorted), whose two triangles, on opposite
/// sides of it, have an apex strictly inside the other's circle. Returns the number of edges whose four
/// points are cocircular.
std::uint64_t check_circles(std::span<const Point2> points, std::span<const SoundTriangle> triangles,
                            std::span<const EdgeUse> uses, FaultList& faults,
                            std::span<const std::array<std::uint32_t, 2>> held = {});

}  // namespace tribunal::verify
