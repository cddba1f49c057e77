// Queries at either end of the range of doubles, which the families tiny and huge share.
#pragma once

#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/degenerate_integers.hpp"
#include "predicates/predicate.hpp"

#include <cmath>

namespace tribunal::queries {

/// Of the predicate's determinant in the coordinates.
constexpr int degree_of(Predicate predicate) {
  return points_of(predicate) == dimension_of(predicate) + 1 ? dimension_of(predicate)
                                                             : dimension_of(predicate) + 2;
}

/// Half the queries random, half exactly degenerate integers, all coordinates below 2^21; then scaled by
/// 2^exponent: for half of them `coordinate_exponent`, for half one around determinant_exponent / degree, at
/// which it is the determinant and not the coordinates that meets the end of the range.
template <int D>
void draw_extreme(Predicate predicate, Random& random, std::span<Point<D>> points, int coordinate_exponent,
                  int determinant_exponent) {
  if (coin(random))
    draw_degenerate_integers(predicate, random, points);
  else
    each_coordinate(points, [&] { return std::ldexp(2 * random.unit() - 1, 20); });
  const auto jitter = static_cast<int>(integer_between(random, -8, 8));
  const int exponent =
      coin(random) ? coordinate_exponent : determinant_exponent / degree_of(predicate) - 20 + jitter;
  for (Point<D>& p : points)
    for (double& c : p.coordinate) c = std::ldexp(c, exponent);
}

}  // namespace tribunal::queries
