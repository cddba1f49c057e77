// The arguments of a formula, as input points or converted to another number type.
#pragma once

#include "predicates/point.hpp"

#include <array>

namespace tribunal {

/// What a backend is asked: the points of one evaluation of `Formula`.
template <class Formula>
using Query = std::array<Point<Formula::dimension>, Formula::points>;

/// The same points with coordinates of type Number.
template <class Number, class Formula>
using Arguments = std::array<std::array<Number, Formula::dimension>, Formula::points>;

/// Applies `convert` to every coordinate.
template <class Number, class Formula, class Conversion>
constexpr Arguments<Number, Formula> convert_arguments(const Query<Formula>& query, Conversion convert) {
  Arguments<Number, Formula> arguments;
  for (int i = 0; i < Formula::points; ++i)
    for (int j = 0; j < Formula::dimension; ++j) arguments[i][j] = convert(query[i][j]);
  return arguments;
}

}  // namespace tribunal
