// Backend `adaptive`: a filter, then exact sums of doubles, after Shewchuk; right where his overflow or
// underflow.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/arithmetic/expansion.hpp"
#include "predicates/arithmetic/exponent_window.hpp"
#include "predicates/backend.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/domain.hpp"
#include "predicates/filters/dynamic.hpp"
#include "predicates/formulas/size.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tribunal {

struct Adaptive {
  static constexpr BackendAbout about{
      .name = "adaptive",
      .cites = "Shewchuk 1997",
      .summary = "a certified filter, then expansions by fused multiply-add, scaled to where they are exact",
      .domain = "finite doubles",
      .exact = true,
  };

  template <int D>
  static Binding<Adaptive> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return Adaptive{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sign = filtered_sign<Formula>(query);
    if (sign != Sign::zero) [[likely]]
      return {sign, Stage::filter};
    if (const auto shift = exact_shift<Formula>(query))
      return {expansion_sign<Formula>(query, *shift), Stage::expansion};
    return {exact_sign<Formula>(query), Stage::exact};
  }

 private:
  struct Coordinate {
    double value;
    friend Expansion operator-(Coordinate a, Coordinate b) { return Expansion::difference(a.value, b.value); }
  };

  /// Expansions are exact as long as nothing they meet overflows or has bits below 2^-1074. With coordinates
  /// that are multiples of 2^l below 2^h, values of degree k are multiples of 2^(k l), and so are all their
  /// components; so a formula of degree d asks for d l >= -1074. It is at most C 2^(d h), its size. A
  /// component exceeds the expansion it leads by a factor of at most 2, a product of two such by 4, and sums
  /// in the making by 2 more: d h + log2 C + 4 <= 1023 is enough. A homogeneous formula may be scaled: the
  /// answer is the exponent s nearest to zero for which l + s and h + s do; nothing where the window is too
  /// wide for any.
  template <class Formula>
  static std::optional<int> exact_shift(const Query<Formula>& query) {
    constexpr FormulaSize size = formula_size<Formula>;
    // |s| stays below 1022 for the widest windows: its power of two is a normal number.
    static_assert(2 <= size.degree && size.degree <= 20);
    const int lowest = -(1074 / size.degree);
    const int highest = (1023 - 4 - (std::ilogb(size.coefficient) + 1)) / size.degree;
    const ExponentWindow window = exponent_window(query);
    if (window.bits() > highest - lowest) return std::nullopt;
    return window.empty() ? 0 : std::clamp(0, lowest - window.lowest, highest - window.highest);
  }

  template <class Formula>
  static Sign expansion_sign(const Query<Formula>& query, int shift) {
    return sign_of(Formula::determinant(convert_arguments<Coordinate, Formula>(
        query, [scale = power_of_two(shift)](double c) { return Coordinate{c * scale}; })));
  }
};
static_assert(Backend<Adaptive, 2> && Backend<Adaptive, 3>);

}  // namespace tribunal
