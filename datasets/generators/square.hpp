// The square lattices that the grid-like generators are made from.
#pragma once

#include "datasets/generators/each.hpp"

namespace tribunal::generators {

/// Side of the smallest k x k square with at least n cells. O(sqrt n).
constexpr std::uint64_t square_side(std::uint64_t n) {
  std::uint64_t side = 1;
  while (side * side < n) ++side;
  return side;
}

/// The first n cells of the smallest square that holds n, row by row: place(column, row) for each, as
/// doubles.
template <class Place>
std::vector<Point2> square(std::uint64_t n, Place place) {
  const std::uint64_t side = square_side(n);
  return each(n, [&](std::uint64_t i) -> Point2 {
    const std::uint64_t column = i % side;
    const std::uint64_t row = i / side;
    return place(static_cast<double>(column), static_cast<double>(row));
  });
}

}  // namespace tribunal::generators
