// The planar predicates in 32-bit words, reduced to sums of three products; shared by the backends after
// Knuth.
#pragma once

#include "predicates/arithmetic/redundant_integer.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/sign.hpp"

#include <cstdint>

namespace tribunal {

/// The widest box of integer points that 32-bit words serve. Only differences matter, so it may lie anywhere.
/// With |difference| <= w = 2^14 - 1 the 2x2 minors and the squared lengths below are at most 2 w^2 = 2^29 -
/// 2^16 + 2, which is less than 2^29 as the redundant products ask; at w = 2^14 they reach it.
inline constexpr std::int32_t knuth_box_width = (1 << 14) - 1;
static_assert(2 * std::int64_t{knuth_box_width} * knuth_box_width < 1 << 29);
static_assert(2 * (std::int64_t{knuth_box_width} + 1) * (knuth_box_width + 1) == 1 << 29);

struct KnuthDifference {
  std::int32_t x, y;
};

inline KnuthDifference knuth_difference(const Point2& a, const Point2& b) {
  return {static_cast<std::int32_t>(a[0] - b[0]), static_cast<std::int32_t>(a[1] - b[1])};
}

constexpr std::int32_t minor(KnuthDifference a, KnuthDifference b) { return a.x * b.y - a.y * b.x; }
constexpr std::int32_t squared_length(KnuthDifference a) { return a.x * a.x + a.y * a.y; }

/// Orientation is one minor: it fits a word.
inline Sign knuth_orient(const Query<Orient<2>>& p) {
  return sign_of(minor(knuth_difference(p[1], p[0]), knuth_difference(p[2], p[0])));
}

/// The incircle determinant is the dot product of x, minors of either sign, and y, squared lengths.
struct KnuthTerms {
  Triple x, y;
};

inline KnuthTerms knuth_terms(const Query<InSphere<2>>& p) {
  const KnuthDifference t = knuth_difference(p[0], p[3]), u = knuth_difference(p[1], p[3]),
                        v = knuth_difference(p[2], p[3]);
  return {{minor(t, u), minor(u, v), minor(v, t)}, {squared_length(v), squared_length(t), squared_length(u)}};
}

}  // namespace tribunal
