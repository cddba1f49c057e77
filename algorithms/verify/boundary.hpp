// Where the triangles end: exactly at the convex hull?
#pragma once

#include "algorithms/verify/triangles.hpp"

namespace tribunal::verify {

/// The edges with one triangle, that triangle on their left, are the edges of `hull` (its vertices
/// counter-clockwise), no more and no fewer. Others are named as a hole where they close up around no area or
/// clockwise, else as a mismatch.
void check_boundary(std::span<const Point2> points, std::span<const std::uint32_t> hull,
                    std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                    FaultList& faults);

/// Euler's formula: a triangulation of n sites, h of them on the boundary of their hull, has 2n - 2 - h
/// triangles.
void check_count(std::uint64_t triangles, std::uint64_t sites, std::uint64_t hull, FaultList& faults);

}  // namespace tribunal::verify
