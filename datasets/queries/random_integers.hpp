// Random integers of a given length, which the families int14 ... int53 share.
#pragma once

#include "datasets/queries/coordinates.hpp"
#include "predicates/predicate.hpp"

namespace tribunal::queries {

/// Coordinates uniform on the integers [0, 2^Bits).
template <int Bits, int D>
void draw_integers(Predicate, Random& random, std::span<Point<D>> points) {
  static_assert(Bits <= 53);
  each_coordinate(points, [&] { return static_cast<double>(random.below(std::uint64_t{1} << Bits)); });
}

}  // namespace tribunal::queries
