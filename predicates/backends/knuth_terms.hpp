// The planar predicates in single words, reduced to sums of three products; shared by the backends after
// Knuth.
#pragma once

#include "predicates/arithmetic/redundant_integer.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/sign.hpp"

#include <concepts>
#include <cstdint>

namespace tribunal {

/// The widest box of integer points that words with digits of d bits serve: 2^14 - 1 or 2^30 - 1. Only
/// differences matter, so it may lie anywhere. With |difference| <= w = 2^d - 1 the 2x2 minors and the
/// squared lengths below are at most 2 w^2 = 2^(2d+1) - 2^(d+2) + 2, which is less than 2^(2d+1) as the
/// redundant products ask; at w = 2^d they reach it.
template <class Word>
inline constexpr Word knuth_box_width = RedundantInteger<Word>::digit_mask;
static_assert(2 * std::int64_t{knuth_box_width<std::int32_t>} * knuth_box_width<std::int32_t> < 1 << 29);
static_assert(2 * knuth_box_width<std::int64_t> * knuth_box_width<std::int64_t> < std::int64_t{1} << 61);

/// What three products serve: a formula of another shape takes more digits (`redundant`).
template <class Formula>
concept SumOfThreeProducts = std::same_as<Formula, Orient<2>> || std::same_as<Formula, InSphere<2>>;

template <class Word>
struct KnuthDifference {
  Word x, y;
};

template <class Word>
KnuthDifference<Word> knuth_difference(const Point2& a, const Point2& b) {
  return {static_cast<Word>(a[0] - b[0]), static_cast<Word>(a[1] - b[1])};
}

template <class Word>
constexpr Word minor(KnuthDifference<Word> a, KnuthDifference<Word> b) {
  return a.x * b.y - a.y * b.x;
}
template <class Word>
constexpr Word squared_length(KnuthDifference<Word> a) {
  return a.x * a.x + a.y * a.y;
}

/// Orientation is one minor: it fits a word.
template <class Word>
Sign knuth_orient(const Query<Orient<2>>& p) {
  return sign_of(minor(knuth_difference<Word>(p[1], p[0]), knuth_difference<Word>(p[2], p[0])));
}

/// The incircle determinant is the dot product of x, minors of either sign, and y, squared lengths.
template <class Word>
struct KnuthTerms {
  Triple<Word> x, y;
};

template <class Word>
KnuthTerms<Word> knuth_terms(const Query<InSphere<2>>& p) {
  const auto t = knuth_difference<Word>(p[0], p[3]), u = knuth_difference<Word>(p[1], p[3]),
             v = knuth_difference<Word>(p[2], p[3]);
  return {{minor(t, u), minor(u, v), minor(v, t)}, {squared_length(v), squared_length(t), squared_length(u)}};
}

}  // namespace tribunal
