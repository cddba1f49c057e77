// Backend `double`: the determinant as written, in rounded arithmetic. It exists to be compared with.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/domain.hpp"

namespace tribunal {

struct Double {
  static constexpr BackendAbout about{
      .name = "double",
      .cites = "common practice",
      .summary = "the determinant in plain double precision, no error bound: wrong near zero",
      .domain = "finite doubles",
      .exact = false,
  };

  template <int D>
  static Binding<Double> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return Double{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    return {sign_of(Formula::determinant(query)), Stage::rounded};
  }
};
static_assert(Backend<Double, 2> && Backend<Double, 3>);

}  // namespace tribunal
