// The sign of a homogeneous formula by integers as wide as the exponents of one query are spread: a stage
// that backends share.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/arithmetic/exponent_window.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/formulas/query.hpp"

#include <optional>

namespace tribunal {

namespace detail {

/// The sign by integers of at most Bits - 1 bits, in units of 2^lowest.
template <class Formula, int Bits>
Sign windowed_sign(const Query<Formula>& query, int lowest) {
  using Integer = SignedInteger<Bits + 1>;
  return sign_of(Formula::determinant(convert_arguments<CountedCoordinate<Bits>, Formula>(
      query, [lowest](double c) { return CountedCoordinate<Bits>{to_units<Integer>(c, lowest)}; })));
}

}  // namespace detail

/// The exact sign where all set bits of the query's coordinates lie within 125 consecutive binary places;
/// nothing where they do not. Three widths: differences fit one word up to 61 places and two up to 125; up to
/// 83 places, as much as doubles of like size ask for, orient3d fits four words. Without allocation.
template <class Formula>
std::optional<Sign> window_sign(const Query<Formula>& query) {
  const ExponentWindow window = exponent_window(query);
  if (window.empty()) return Sign::zero;  // every coordinate is zero
  if (window.bits() <= 61) return detail::windowed_sign<Formula, 62>(query, window.lowest);
  if (window.bits() <= 83) return detail::windowed_sign<Formula, 84>(query, window.lowest);
  if (window.bits() <= 125) return detail::windowed_sign<Formula, 126>(query, window.lowest);
  return std::nullopt;
}

}  // namespace tribunal
