// Signs for those who have none of their own: what a kernel answers about formulas that its backend does not
// evaluate.
#pragma once

#include "predicates/backends/exact_sign.hpp"
#include "predicates/backends/window_sign.hpp"
#include "predicates/decision.hpp"
#include "predicates/filters/dynamic.hpp"

namespace tribunal {

/// The exact sign of any formula at any finite doubles: a certified filter, then integers as wide as the
/// query's exponents ask for. Bound to nothing.
struct Certified {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sign = filtered_sign<Formula>(query);
    if (sign != Sign::zero) [[likely]]
      return {sign, Stage::filter};
    if (const auto windowed = window_sign<Formula>(query)) return {*windowed, Stage::integer};
    return {exact_sign<Formula>(query), Stage::exact};
  }
};

}  // namespace tribunal
