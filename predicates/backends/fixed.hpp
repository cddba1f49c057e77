// Backend `fixed`: integers of one width for a whole window of exponents, and nothing else.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/arithmetic/exponent_window.hpp"
#include "predicates/backend.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/domain.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tribunal {

class Fixed {
 public:
  static constexpr BackendAbout about{
      .name = "fixed",
      .cites = "this project",
      .summary =
          "straight-line integers of 126 bits per coordinate difference, as wide as the formula makes them",
      .domain = "multiples of a common 2^e below 2^(e + 125) in magnitude",
      .exact = true,
  };

  template <int D>
  static Binding<Fixed> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_environment()) return *refusal;
    ExponentWindow window;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_finite(points[i])) return Refusal{i, "a coordinate is not finite"};
      for (int axis = 0; axis < D; ++axis) {
        window.include(points[i][axis]);
        if (window.bits() > coordinate_bits)
          return Refusal{i, name_coordinate(axis, points[i][axis]) +
                                " spreads the bits of the coordinates over more than 125 places"};
      }
    }
    return Fixed(window);
  }

  /// Whether p, bound or not, fits the window of the points.
  template <int D>
  bool admits(const Point<D>& p) const {
    if (!is_finite(p)) return false;
    ExponentWindow joint = window_;
    for (const double c : p.coordinate) joint.include(c);
    return joint.lowest == window_.lowest && joint.highest == window_.highest;
  }

  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const auto& p) { return admits(p); }));
    const auto determinant = Formula::determinant(convert_arguments<Coordinate, Formula>(
        query, [unit = window_.lowest](double c) { return Coordinate{to_units<Int128>(c, unit)}; }));
    return {sign_of(determinant), Stage::integer};
  }

 private:
  /// Differences have one more, which with their sign fill an Int128.
  static constexpr int coordinate_bits = 125;

  using Coordinate = CountedCoordinate<coordinate_bits + 1>;

  explicit Fixed(const ExponentWindow& window) : window_(window) {}

  ExponentWindow window_;
};
static_assert(Backend<Fixed, 2> && Backend<Fixed, 3>);

}  // namespace tribunal
