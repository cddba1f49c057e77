// Backend `filtered`, the default: a certified first stage, then integers where the data allow, then GMP.
#pragma once

#include "predicates/backends/backend.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/domain.hpp"
#include "predicates/filters/dynamic.hpp"
#include "predicates/lattice.hpp"

#include <algorithm>
#include <optional>

namespace tribunal {

class Filtered {
 public:
  static constexpr BackendAbout about{
      .name = "filtered",
      .cites = "Fortune and Van Wyk 1993; Bartels, Fisikopoulos and Weiser 2023",
      .summary = "a branchless certified filter, then fixed-width integers on a lattice, else GMP",
      .domain = "finite doubles",
      .exact = true,
  };

  template <int D>
  static Binding<Filtered> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_non_finite(points)) return *refusal;
    auto found = Lattice::find(points);
    if (auto* lattice = std::get_if<Lattice>(&found)) return Filtered(*lattice);
    return Filtered(std::nullopt);
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
    return decide_exactly<Formula>(query);
  }

 private:
  explicit Filtered(std::optional<Lattice> lattice) : lattice_(lattice) {}

  /// Any finite point may be asked about, also one that was never bound: the lattice is asked before it is
  /// trusted.
  template <class Formula>
  [[gnu::noinline]] Decision decide_exactly(const Query<Formula>& query) const {
    const bool on_lattice = lattice_ && std::all_of(query.begin(), query.end(),
                                                    [&](const auto& p) { return lattice_->contains(p); });
    if (on_lattice) return {integer_sign<Formula>(query, *lattice_), Stage::integer};
    return {exact_sign<Formula>(query), Stage::exact};
  }

  std::optional<Lattice> lattice_;  ///< of the bound points, where they have one
};
static_assert(Backend<Filtered, 2> && Backend<Filtered, 3>);

}  // namespace tribunal
