// Backend `interval`: the determinant in intervals, and integers of unbounded size where they hold zero.
#pragma once

#include "predicates/arithmetic/interval.hpp"
#include "predicates/backend.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/domain.hpp"

namespace tribunal {

struct IntervalArithmetic {
  static constexpr BackendAbout about{
      .name = "interval",
      .cites = "Moore 1966; Bronnimann, Burnikel and Pion 2001",
      .summary = "double intervals rounded outwards in the default rounding mode, then unbounded integers",
      .domain = "finite doubles",
      .exact = true,
  };

  template <int D>
  static Binding<IntervalArithmetic> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return IntervalArithmetic{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const auto enclosed = convert_arguments<Interval, Formula>(query, [](double c) { return Interval(c); });
    if (const auto sign = certain_sign(Formula::determinant(enclosed))) return {*sign, Stage::filter};
    return {exact_sign<Formula>(query), Stage::exact};
  }
};
static_assert(Backend<IntervalArithmetic, 2> && Backend<IntervalArithmetic, 3>);

}  // namespace tribunal
