// Backend `float`: the determinant in single precision. It exists to be compared with.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/domain.hpp"

namespace tribunal {

/// Two things go wrong here: each coordinate is rounded to 24 bits before anything is computed (to infinity
/// beyond 2^128, to zero below 2^-149), and then the determinant is. On integers below 2^24 only the second
/// happens.
struct Float {
  static constexpr BackendAbout about{
      .name = "float",
      .cites = "common practice",
      .summary = "single precision, no error bound: even the coordinates are rounded, to 24 bits",
      .domain = "finite doubles",
      .exact = false,
  };

  template <int D>
  static Binding<Float> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return Float{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const auto rounded =
        convert_arguments<float, Formula>(query, [](double c) { return static_cast<float>(c); });
    return {sign_of(Formula::determinant(rounded)), Stage::rounded};
  }
};
static_assert(Backend<Float, 2> && Backend<Float, 3>);

}  // namespace tribunal
