// Backend `double-fma`: the determinant as a compiler contracts it. It exists to show what that does.
#pragma once

#include "predicates/arithmetic/fused.hpp"
#include "predicates/backend.hpp"
#include "predicates/domain.hpp"

namespace tribunal {

class DoubleFma {
 public:
  static constexpr BackendAbout about{
      .name = "double-fma",
      .cites = "common practice, by way of -ffp-contract=fast",
      .summary = "double precision with products and sums fused: fewer wrong signs, but not antisymmetric",
      .domain = "finite doubles",
      .exact = false,
  };

  template <int D>
  static Binding<DoubleFma> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return DoubleFma{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    return {has_instruction_ ? by_instruction<Formula>(query) : contracted_sign<Formula>(query),
            Stage::rounded};
  }

 private:
  template <class Formula>
  static Sign contracted_sign(const Query<Formula>& query) {
    const auto arguments = convert_arguments<Fused, Formula>(query, [](double c) { return Fused{c}; });
    return sign_of(Formula::determinant(arguments));
  }

  // The same bits either way; only that std::fma in generic x86-64 code is a library call per operation.
#if defined(__x86_64__)
  template <class Formula>
  [[gnu::target("fma"), gnu::flatten]] static Sign by_instruction(const Query<Formula>& query) {
    return contracted_sign<Formula>(query);
  }
  bool has_instruction_ = __builtin_cpu_supports("fma") != 0;
#else
  template <class Formula>
  static Sign by_instruction(const Query<Formula>& query) {
    return contracted_sign<Formula>(query);
  }
  bool has_instruction_ = true;
#endif
};
static_assert(Backend<DoubleFma, 2> && Backend<DoubleFma, 3>);

}  // namespace tribunal
