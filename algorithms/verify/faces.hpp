// The regions into which segments divide the plane.
#pragma once

#include "algorithms/verify/pieces.hpp"

namespace tribunal::verify {

/// Names each bounded region between pieces that is not covered though no hole marks it, and each hole that
/// is covered. Regions are covered whole or not at all.
void check_regions(std::span<const Point2> points, std::span<const Piece> pieces,
                   std::span<const Point2> holes, FaultList& faults);

}  // namespace tribunal::verify
