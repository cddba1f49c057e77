// The sign of a homogeneous formula, exactly, for any finite doubles: the last stage that backends share.
#pragma once

#include "predicates/arithmetic/big_integer.hpp"
#include "predicates/arithmetic/exponent_window.hpp"
#include "predicates/formulas/query.hpp"

namespace tribunal {

/// Scales all coordinates by one power of two that makes them integers; a homogeneous polynomial keeps its
/// sign. Exact over all finite doubles; integers reach (2100 + 53) * degree bits when exponents are spread
/// over the whole range.
template <class Formula>
Sign exact_sign(const Query<Formula>& query) {
  const int exponent = exponent_window(query).lowest;
  return sign_of(Formula::determinant(
      convert_arguments<BigInteger, Formula>(query, [&](double c) { return scaled_integer(c, exponent); })));
}

}  // namespace tribunal
