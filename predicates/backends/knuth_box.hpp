// What `knuth` and `knuth64` share: the redundant sign test on a box of integers, in words of either size.
#pragma once

#include "predicates/backends/knuth_terms.hpp"
#include "predicates/decision.hpp"
#include "predicates/integer_box.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tribunal {

/// Planar points in a box of the width that words of this type serve.
template <class Word>
class KnuthBox {
 public:
  static Binding<KnuthBox> find(std::span<const Point2> points) {
    auto box = IntegerBox<2>::find(points, static_cast<double>(knuth_box_width<Word>));
    if (auto* refusal = std::get_if<Refusal>(&box)) return std::move(*refusal);
    return KnuthBox(std::get<IntegerBox<2>>(box));
  }
  bool contains(const Point2& p) const { return box_.contains(p); }

  template <SumOfThreeProducts Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const Point2& p) { return contains(p); }));
    return {sign(query), Stage::integer};
  }

 private:
  explicit KnuthBox(const IntegerBox<2>& box) : box_(box) {}

  static Sign sign(const Query<Orient<2>>& query) { return knuth_orient<Word>(query); }
  static Sign sign(const Query<InSphere<2>>& query) {
    const KnuthTerms<Word> terms = knuth_terms<Word>(query);
    return sign_of_dot_product(terms.x, terms.y);
  }

  IntegerBox<2> box_;
};

}  // namespace tribunal
