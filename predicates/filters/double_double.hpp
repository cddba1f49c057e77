// A filter twice as fine as double precision: pairs of doubles, with the magnitude that their error is
// proportional to.
#pragma once

#include "predicates/arithmetic/fused_multiply_add.hpp"
#include "predicates/filters/sign_beyond.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/sign.hpp"

#include <cmath>

namespace tribunal {

// Derivation (operations after Dekker 1971; Joldes, Muller and Popescu 2017 prove tighter constants for
// some). Let u = 2^-53. A value x is held as high + low, where high = fl(high + low) and so |low| <= u
// |high|, with a magnitude m. Promised are |high| <= m (1 + O(u)) and |high + low - x| <= c u^2 m.
//
//   difference of coordinates   m = |high|               c = 0
//   sum                         m = fl(ma + mb)          c = max(ca, cb) + 3
//   product                     m = fl(fl(ma mb) + T)    c = ca + cb + 8
//
// each c times (1 + O(u)). Difference: high = fl(a - b), and what its rounding lost is a double (Knuth's
// two-sum). Sum: the high parts add exactly to s + e with |e| <= u |s|; the sum of the low parts errs by u^2
// (ma + mb), and adding e to it by 2 u^2 (ma + mb). Product, with P = ma mb: the high parts multiply exactly
// to p + e by a fused multiply-add; left out is low low <= u^2 P; the two cross products err by u^2 P each,
// their sum, at most 2 u P, by 2 u^2 P; adding e, at most u P, to it by 3 u^2 P: 8 together. Where p or a
// cross product underflows it errs by 2^-1075 = u^2 T besides, T = 2^-969; there are three, and c is at
// least 8. Renormalising is exact, for the larger part is a multiple of the last bit of the smaller one.
//
// The sign of high is that of high + low, so |high| > fl(K m) with K >= c u^2 (1 + O(u)) proves the sign of
// x. Overflow leaves an infinite m or a high that is NaN; neither passes the test.

/// A coordinate, exact.
struct DoubleDoubleCoordinate {
  double value;
};

/// A difference of two coordinates, exact: its magnitude is its own.
struct DoubleDoubleDifference {
  double high, low;
  double magnitude() const { return std::fabs(high); }
  DoubleDoubleDifference operator-() const { return {-high, -low}; }
};

/// Any other value.
struct DoubleDoubleValue {
  double high, low, bound;
  double magnitude() const { return bound; }
  DoubleDoubleValue operator-() const { return {-high, -low, bound}; }
};

template <class Number>
concept DoubleDouble = requires(Number a) {
  a.high + a.low + a.magnitude();
};

inline DoubleDoubleDifference operator-(DoubleDoubleCoordinate a, DoubleDoubleCoordinate b) {
  const double high = a.value - b.value;
  const double minus_b = high - a.value, from_a = high - minus_b;
  return {high, (a.value - from_a) - (b.value + minus_b)};
}

template <DoubleDouble Left, DoubleDouble Right>
inline DoubleDoubleValue operator+(Left a, Right b) {
  const double s = a.high + b.high;
  const double from_b = s - a.high, from_a = s - from_b;
  const double rest = ((a.high - from_a) + (b.high - from_b)) + (a.low + b.low);
  const double high = s + rest;
  return {high, (s - high) + rest, a.magnitude() + b.magnitude()};
}

template <DoubleDouble Left, DoubleDouble Right>
inline DoubleDoubleValue operator-(Left a, Right b) {
  return a + -b;
}

template <DoubleDouble Left, DoubleDouble Right>
inline DoubleDoubleValue operator*(Left a, Right b) {
  constexpr double threshold = 0x1p-969;  // T of the derivation
  const double p = a.high * b.high;
  const double rest = __builtin_fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high);
  const double high = p + rest;
  return {high, (p - high) + rest, a.magnitude() * b.magnitude() + threshold};
}

namespace detail {

/// c of the derivation.
struct DoubleDoubleError {
  double units;
};
struct DoubleDoubleErrorOfCoordinate {};

/// Covers the (1 + O(u)) factors of one operation and the rounding of c itself.
constexpr DoubleDoubleError enlarged_error(double c) { return {c * (1 + 0x1p-42)}; }

constexpr DoubleDoubleError operator-(DoubleDoubleErrorOfCoordinate, DoubleDoubleErrorOfCoordinate) {
  return {0};
}
constexpr DoubleDoubleError operator+(DoubleDoubleError a, DoubleDoubleError b) {
  return enlarged_error((a.units > b.units ? a.units : b.units) + 3);
}
constexpr DoubleDoubleError operator-(DoubleDoubleError a, DoubleDoubleError b) { return a + b; }
constexpr DoubleDoubleError operator*(DoubleDoubleError a, DoubleDoubleError b) {
  return enlarged_error(a.units + b.units + 8);
}

}  // namespace detail

/// K of the derivation.
template <class Formula>
constexpr double double_double_coefficient =
    detail::enlarged_error(
        Formula::determinant(Arguments<detail::DoubleDoubleErrorOfCoordinate, Formula>{}).units)
        .units
    * 0x1p-106;

namespace detail {

template <class Formula>
inline Sign double_double_sign_here(const Query<Formula>& query) {
  const auto d = Formula::determinant(convert_arguments<DoubleDoubleCoordinate, Formula>(
      query, [](double c) { return DoubleDoubleCoordinate{c}; }));
  return sign_beyond(d.high, double_double_coefficient<Formula> * d.magnitude());
}

template <class Formula>
TRIBUNAL_FMA [[gnu::flatten]] Sign double_double_sign_by_instruction(const Query<Formula>& query) {
  return double_double_sign_here<Formula>(query);
}

}  // namespace detail

/// The sign of the determinant where double-double arithmetic proves it; zero says "not proven". Sound for
/// all finite doubles under round-to-nearest with subnormals. Without FMA instructions the C library's
/// function does their work: slower, and the same bits.
template <class Formula>
Sign double_double_sign(const Query<Formula>& query) {
  if (has_fused_multiply_add()) return detail::double_double_sign_by_instruction<Formula>(query);
  return detail::double_double_sign_here<Formula>(query);
}

}  // namespace tribunal
