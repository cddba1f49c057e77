// Backend `knuth-as-printed`: the program in Barth's notes, misprints included. It exists to be refuted.
#pragma once

#include "predicates/arithmetic/redundant_as_printed.hpp"
#include "predicates/backend.hpp"
#include "predicates/backends/knuth_terms.hpp"
#include "predicates/integer_box.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace tribunal {

class KnuthAsPrinted {
 public:
  static constexpr BackendAbout about{
      .name = "knuth-as-printed",
      .cites = "Barth section 3.7, after Knuth 1993",
      .summary = "an exhibit: the redundant sign test with the misprints of the text, wrong on many circles",
      .domain = "integers in a box at most 2^14 - 1 wide",
      .exact = false,
  };

  static Binding<KnuthAsPrinted> bind(std::span<const Point2> points) {
    auto box = IntegerBox<2>::find(points, knuth_box_width<std::int32_t>);
    if (auto* refusal = std::get_if<Refusal>(&box)) return std::move(*refusal);
    return KnuthAsPrinted(std::get<IntegerBox<2>>(box));
  }
  bool admits(const Point2& p) const { return box_.contains(p); }

  /// The text prints no orientation test; that one is right. Nothing here is certified.
  template <SumOfThreeProducts Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const Point2& p) { return admits(p); }));
    return {sign(query), Stage::rounded};
  }

 private:
  explicit KnuthAsPrinted(const IntegerBox<2>& box) : box_(box) {}

  static Sign sign(const Query<Orient<2>>& query) { return knuth_orient<std::int32_t>(query); }
  static Sign sign(const Query<InSphere<2>>& query) {
    const auto terms = knuth_terms<std::int32_t>(query);
    return sign_of_dot_product_as_printed(terms.x, terms.y);
  }

  IntegerBox<2> box_;
};
static_assert(Backend<KnuthAsPrinted, 2>);

}  // namespace tribunal
