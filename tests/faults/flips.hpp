// Triangulations that are valid but need not be Delaunay.
#pragma once

#include "tests/faults/mesh_map.hpp"
#include "tests/faults/samples.hpp"

namespace tribunal::faults {

/// The four points around an interior edge form a strictly convex quadrilateral.
inline bool is_flippable(const std::vector<LatticePoint>& points, const Side& side, const Side& across) {
  return area(points[side.apex], points[side.from], points[across.apex]) > 0 &&
         area(points[across.apex], points[side.to], points[side.apex]) > 0;
}

/// Replaces the edge of a flippable quadrilateral by its other diagonal.
inline void flip(std::vector<Triangle>& triangles, const Side& side, const Side& across) {
  triangles[side.triangle] = {side.apex, side.from, across.apex};
  triangles[across.triangle] = {across.apex, side.to, side.apex};
}

/// Up to `flips` random flips: the mesh stays a triangulation of the same sites.
inline void flip_at_random(Sample& sample, Random& random, int flips) {
  for (int i = 0; i < flips; ++i) {
    const MeshMap map(sample.triangles);
    const auto side = pick(map.interior(), random,
                           [&](const Side& s) { return is_flippable(sample.points, s, *map.across(s)); });
    if (!side) return;
    flip(sample.triangles, *side, *map.across(*side));
  }
}

}  // namespace tribunal::faults
