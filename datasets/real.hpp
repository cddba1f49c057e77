// What the shipped real data hold besides points.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal {

/// The 847 segments of the dataset `coast`, as pairs of indices into its 850 points, smaller index first.
std::vector<std::array<std::uint32_t, 2>> coast_segments();

struct RealGraph {
  std::vector<Point2> points;
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< by index into the points
};

/// The county borders arc by arc, each border once: 46,565 points, those where arcs meet repeated, and the
/// segments between consecutive points of each arc; steps of no length are left out.
RealGraph county_arcs();

}  // namespace tribunal
