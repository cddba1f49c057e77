// Backend `gmp`: every sign by integers of unbounded size.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/domain.hpp"

namespace tribunal {

struct Gmp {
  static constexpr BackendAbout about{
      .name = "gmp",
      .cites = "Granlund et al., GMP",
      .summary = "exact integers of unbounded size on every call",
      .domain = "finite doubles",
      .exact = true,
  };

  template <int D>
  static Binding<Gmp> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return Gmp{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    return {exact_sign<Formula>(query), Stage::exact};
  }
};
static_assert(Backend<Gmp, 2> && Backend<Gmp, 3>);

}  // namespace tribunal
