// Backend `fortune-van-wyk`: sizes known in advance make the filter one constant and the exact stage
// straight-line.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/filters/sign_beyond.hpp"
#include "predicates/filters/static.hpp"
#include "predicates/lattice.hpp"

#include <algorithm>
#include <cassert>
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

  template <int D>
  static Binding<FortuneVanWyk> bind(std::span<const Point<D>> points) {
    auto found = Lattice::find(points);
    if (auto* refusal = std::get_if<Refusal>(&found)) return std::move(*refusal);
    return FortuneVanWyk(std::get<Lattice>(found));
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return lattice_.contains(p);
  }

  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const auto& p) { return admits(p); }));
    const double error = error_bound<Formula>();
    const Sign sign = sign_beyond(Formula::determinant(query), error);
    if (sign != Sign::zero) [[likely]]
      return {sign, Stage::filter};
    return with_coordinates<Formula>(
        query, [this](auto... c) { return this->template decide_close<Formula>(c...); });
  }

 private:
  explicit FortuneVanWyk(const Lattice& lattice)
      : lattice_(lattice),
        orient2d_error_(scaled_error<Orient<2>>()),
        incircle_error_(scaled_error<InSphere<2>>()),
        orient3d_error_(scaled_error<Orient<3>>()),
        insphere_error_(scaled_error<InSphere<3>>()) {}

  template <class Formula>
  [[gnu::noinline]] Decision decide_close(std::same_as<double> auto... coordinates) const {
    if (error_bound<Formula>() == 0) return {Sign::zero, Stage::filter};  // nothing was rounded
    return {integer_sign<Formula>(query_of<Formula>(coordinates...), lattice_), Stage::integer};
  }

  template <class Formula>
  double scaled_error() const {
    constexpr int degree = IntegerDeterminant<Formula, Lattice::most_bits>::degree;
    return static_error_bound<Formula>(lattice_.bits(), lattice_.exponent(), degree);
  }
  /// Those of the kernel's predicates are kept; a user's formula has its bound computed when it is asked.
  template <class Formula>
  double error_bound() const {
    if constexpr (std::same_as<Formula, Orient<2>>)
      return orient2d_error_;
    else if constexpr (std::same_as<Formula, InSphere<2>>)
      return incircle_error_;
    else if constexpr (std::same_as<Formula, Orient<3>>)
      return orient3d_error_;
    else if constexpr (std::same_as<Formula, InSphere<3>>)
      return insphere_error_;
    else
      return scaled_error<Formula>();
  }

  Lattice lattice_;
  double orient2d_error_, incircle_error_, orient3d_error_, insphere_error_;
};
static_assert(Backend<FortuneVanWyk, 2> && Backend<FortuneVanWyk, 3>);

}  // namespace tribunal
