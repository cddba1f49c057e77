// The front door of the planar algorithms: any finite points in, one Triangulation out.
#pragma once

#include "algorithms/algorithm.hpp"

#include <span>

namespace tribunal {

/// Triangulates `points` by `algorithm`, inserting in the order of `order` (a permutation of all indices).
///
/// Merges duplicates (the first occurrence by index stands for all), recognises point sets of dimension 0 and
/// 1, moves the first site that is not collinear with the two before it to third place, runs the algorithm
/// and turns its abandonment into an outcome. Settings that the algorithm does not take are `refused_input`.
/// Never throws for geometric reasons. The kernel must be bound to `points`. `values` are data by point, for
/// algorithms that read them.
Triangulation triangulate(std::span<const Point2> points, std::span<const Index> order, const Kernel2& kernel,
                          const PlanarAlgorithm& algorithm, const Settings& settings = {},
                          std::span<const double> values = {});

}  // namespace tribunal
