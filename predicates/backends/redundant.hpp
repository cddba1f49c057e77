// Backend `redundant`: Knuth's redundant representation, carried from three digits to as many as a formula
// takes.
#pragma once

#include "predicates/arithmetic/redundant_number.hpp"
#include "predicates/backend.hpp"
#include "predicates/lattice.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

namespace tribunal {

class Redundant {
 public:
  static constexpr BackendAbout about{
      .name = "redundant",
      .cites = "after Knuth 1993, The Stanford GraphBase; Barth section 3.7",
      .summary =
          "64-bit words only: digits of radix 2^28 that may overlap, carried only before they would not fit",
      .domain = "multiples of a common 2^e, e >= -1022, in a box at most 2^53 - 1 of them wide",
      .exact = true,
  };

  template <int D>
  static Binding<Redundant> bind(std::span<const Point<D>> points) {
    auto found = Lattice::find(points);
    if (auto* refusal = std::get_if<Refusal>(&found)) return std::move(*refusal);
    return Redundant(std::get<Lattice>(found));
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return lattice_.contains(p);
  }

  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const auto& p) { return admits(p); }));
    const bool one_digit = lattice_.bits() <= redundant_digit_bits;
    return {one_digit ? sign<1, Formula>(query) : sign<2, Formula>(query), Stage::integer};
  }

 private:
  explicit Redundant(const Lattice& lattice) : lattice_(lattice) {}

  /// A coordinate whose differences have so many digits: one up to 28 bits, two up to 56.
  template <int Digits>
  struct Coordinate {
    double value, inverse_unit;

    /// Exact: the difference is, and so is scaling it by a power of two to an integer.
    friend auto operator-(Coordinate a, Coordinate b) {
      return to_redundant<Digits>(static_cast<std::int64_t>((a.value - b.value) * a.inverse_unit));
    }
  };

  template <int Digits, class Formula>
  Sign sign(const Query<Formula>& query) const {
    return sign_of(Formula::determinant(
        convert_arguments<Coordinate<Digits>, Formula>(query, [unit = lattice_.inverse_unit()](double c) {
          return Coordinate<Digits>{c, unit};
        })));
  }

  Lattice lattice_;
};
static_assert(Backend<Redundant, 2> && Backend<Redundant, 3>);

}  // namespace tribunal
