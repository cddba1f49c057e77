// What a fuzzer asks: one call of a predicate, with its arguments as plain numbers.
#pragma once

#include "predicates/formulas/query.hpp"
#include "predicates/point.hpp"
#include "predicates/predicate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace tribunal::bench::fuzz {

/// A predicate and the coordinates of its points, one point after the other. Flat, so that generators,
/// mutations and the shrinker need not know the dimension.
struct Case {
  static constexpr std::size_t most_numbers = 15;

  Predicate predicate = Predicate::orient2d;
  std::array<double, most_numbers> storage{};  ///< beyond size() zero

  int dimension() const { return dimension_of(predicate); }
  int points() const { return points_of(predicate); }
  std::size_t size() const {
    return static_cast<std::size_t>(dimension()) * static_cast<std::size_t>(points());
  }

  std::span<double> numbers() { return {storage.data(), size()}; }
  std::span<const double> numbers() const { return {storage.data(), size()}; }
  std::span<double> point(int i) {
    return numbers().subspan(offset(i), static_cast<std::size_t>(dimension()));
  }
  std::span<const double> point(int i) const {
    return numbers().subspan(offset(i), static_cast<std::size_t>(dimension()));
  }

  void swap_points(int i, int j) {
    if (i != j) std::swap_ranges(point(i).begin(), point(i).end(), point(j).begin());
  }

  void copy_point(int from, int to) {
    if (from != to) std::copy(point(from).begin(), point(from).end(), point(to).begin());
  }

  /// Equality of numbers: -0 equals +0.
  friend bool operator==(const Case&, const Case&) = default;

 private:
  std::size_t offset(int i) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension());
  }
};

/// Point i of a case in D dimensions.
template <int D>
Point<D> point_of(const Case& asked, int i) {
  Point<D> p{};
  std::copy_n(asked.point(i).begin(), D, p.coordinate.begin());
  return p;
}

/// The case as arguments of the formula that is its predicate.
template <class Formula>
Query<Formula> arguments_of(const Case& asked) {
  Query<Formula> query;
  for (int i = 0; i < Formula::points; ++i) query[i] = point_of<Formula::dimension>(asked, i);
  return query;
}

}  // namespace tribunal::bench::fuzz
