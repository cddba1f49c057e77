// Backend `long-double`: the determinant in the widest precision the processor has. It exists to be compared
// with.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/domain.hpp"

namespace tribunal {

struct LongDouble {
  static constexpr BackendAbout about{
      .name = "long-double",
      .cites = "common practice",
      .summary =
          "the determinant in extended precision (64 bits on x86), no error bound: wrong nearer to zero",
      .domain = "finite doubles",
      .exact = false,
  };

  template <int D>
  static Binding<LongDouble> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return LongDouble{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const auto widened =
        convert_arguments<long double, Formula>(query, [](double c) { return static_cast<long double>(c); });
    return {sign_of(Formula::determinant(widened)), Stage::rounded};
  }
};
static_assert(Backend<LongDouble, 2> && Backend<LongDouble, 3>);

}  // namespace tribunal
