// The arguments of a formula, as input points or converted to another number type.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

namespace tribunal {

/// What a backend is asked: the points of one evaluation of `Formula`.
template <class Formula>
using Query = std::array<Point<Formula::dimension>, Formula::points>;

/// The same points with coordinates of type Number.
template <class Number, class Formula>
using Arguments = std::array<std::array<Number, Formula::dimension>, Formula::points>;

namespace detail {
template <class Formula, class Visitor, std::size_t... I>
constexpr auto with_coordinates(const Query<Formula>& query, Visitor visit, std::index_sequence<I...>) {
  return visit(query[I / Formula::dimension][I % Formula::dimension]...);
}
}  // namespace detail

/// visit(x0, y0, ..., xn, yn). A query that is handed on coordinate by coordinate has no address, so that
/// compilers keep it in registers: what calls an exact stage that it hardly ever needs should call it so.
template <class Formula, class Visitor>
constexpr auto with_coordinates(const Query<Formula>& query, Visitor visit) {
  return detail::with_coordinates<Formula>(
      query, visit, std::make_index_sequence<std::size_t{Formula::dimension} * Formula::points>{});
}

/// The way back.
template <class Formula, std::same_as<double>... Coordinates>
constexpr Query<Formula> query_of(Coordinates... coordinates) {
  const std::array<double, sizeof...(Coordinates)> flat{coordinates...};
  Query<Formula> query;
  for (int i = 0; i < Formula::points; ++i)
    for (int j = 0; j < Formula::dimension; ++j) query[i][j] = flat[i * Formula::dimension + j];
  return query;
}

/// Applies `convert` to every coordinate.
template <class Number, class Formula, class Conversion>
constexpr Arguments<Number, Formula> convert_arguments(const Query<Formula>& query, Conversion convert) {
  Arguments<Number, Formula> arguments;
  for (int i = 0; i < Formula::points; ++i)
    for (int j = 0; j < Formula::dimension; ++j) arguments[i][j] = convert(query[i][j]);
  return arguments;
}

}  // namespace tribunal
