// Backend `fortune-van-wyk`: sizes known in advance make the filter one constant and the exact stage
// straight-line.
#pragma once

#include "predicates/backends/backend.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/filters/static.hpp"
#include "predicates/lattice.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>

namespace tribunal {

class FortuneVanWyk {
 public:
  static constexpr BackendAbout about{
      .name = "fortune-van-wyk",
      .cites = "Fortune and Van Wyk 1993; Barth section 3.7",
      .summary =
          "a constant error bound from the bit length of the data, then integers of a width fixed by it",
      .domain = "multiples of a common 2^e, e >= -1022, in a box at most 2^53 - 1 of them wide",
      .exact = true,
  };

  static Binding<FortuneVanWyk> bind(std::span<const Point2> points) {
    auto found = Lattice::find(points);
    if (auto* refusal = std::get_if<Refusal>(&found)) return std::move(*refusal);
    return FortuneVanWyk(std::get<Lattice>(found));
  }
  bool admits(const Point2& p) const { return lattice_.contains(p); }

  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const Point2& p) { return admits(p); }));
    const double determinant = Formula::determinant(query);
    const double error = error_bound<Formula>();
    if (std::fabs(determinant) > error) [[likely]]
      return {sign_of(determinant), Stage::filter};
    if (error == 0) return {Sign::zero, Stage::filter};  // nothing was rounded
    return {integer_sign<Formula>(query, lattice_), Stage::integer};
  }

 private:
  explicit FortuneVanWyk(const Lattice& lattice)
      : lattice_(lattice),
        orient_error_(scaled_error<Orient<2>>(lattice)),
        in_sphere_error_(scaled_error<InSphere<2>>(lattice)) {}

  template <class Formula>
  static double scaled_error(const Lattice& lattice) {
    constexpr int degree = IntegerDeterminant<Formula, Lattice::most_bits>::degree;
    return static_error_bound<Formula>(lattice.bits(), lattice.exponent(), degree);
  }
  template <class Formula>
  double error_bound() const {
    if constexpr (std::same_as<Formula, Orient<2>>) return orient_error_;
    if constexpr (std::same_as<Formula, InSphere<2>>) return in_sphere_error_;
  }

  Lattice lattice_;
  double orient_error_, in_sphere_error_;
};
static_assert(Backend<FortuneVanWyk, 2>);

}  // namespace tribunal
