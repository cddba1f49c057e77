// Backend `knuth`: exact signs in 32-bit words, by redundant integers.
#pragma once

#include "predicates/arithmetic/redundant_integer.hpp"
#include "predicates/backends/backend.hpp"
#include "predicates/backends/knuth_terms.hpp"
#include "predicates/integer_box.hpp"

#include <algorithm>
#include <cassert>

namespace tribunal {

class Knuth {
 public:
  static constexpr BackendAbout about{
      .name = "knuth",
      .cites = "Knuth 1993, The Stanford GraphBase; Barth section 3.7",
      .summary = "32-bit words only: a 2^28 + b 2^14 + c with digits that may overlap",
      .domain = "integers in a box at most 2^14 - 1 wide",
      .exact = true,
  };

  static Binding<Knuth> bind(std::span<const Point2> points) {
    auto box = IntegerBox<2>::find(points, knuth_box_width);
    if (auto* refusal = std::get_if<Refusal>(&box)) return std::move(*refusal);
    return Knuth(std::get<IntegerBox<2>>(box));
  }
  bool admits(const Point2& p) const { return box_.contains(p); }

  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const Point2& p) { return admits(p); }));
    return {sign(query), Stage::integer};
  }

 private:
  explicit Knuth(const IntegerBox<2>& box) : box_(box) {}

  static Sign sign(const Query<Orient<2>>& query) { return knuth_orient(query); }
  static Sign sign(const Query<InSphere<2>>& query) {
    const KnuthTerms terms = knuth_terms(query);
    return sign_of_dot_product(terms.x, terms.y);
  }

  IntegerBox<2> box_;
};
static_assert(Backend<Knuth, 2>);

}  // namespace tribunal
