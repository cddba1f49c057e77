// A filter sound over all finite doubles: each value carries the magnitude that its rounding error is
// proportional to.
#pragma once

#include "predicates/filters/sign_beyond.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/sign.hpp"

#include <cmath>
#include <limits>

namespace tribunal {

// Derivation (after Fortune and Van Wyk 1993; Shewchuk 1997; Bartels, Fisikopoulos and Weiser 2023). Let u =
// 2^-53 and N = 2^-1022. A rounded sum has relative error u, exact where it is subnormal; a rounded product
// has relative error u, or, where it underflows, absolute error 2^-1075 = u N. Each value x of the formula is
// computed as x' together with a magnitude m, and keeps two promises: |x'| <= m and |x' - x| <= c u m, where
// c depends on the shape of the formula alone and is found at compile time.
//
//   difference of coordinates   m = |x'|                 c = 1
//   sum                         m = fl(ma + mb)          c = max(ca, cb) + 1
//   product                     m = fl(fl(ma mb) + N)    c = ca + cb + 1
//
// each c times (1 + O(u)). Sum: the operands err by max(ca, cb) u (ma + mb) and rounding adds u |x'| <= u m,
// for rounding is monotone. Product: P = ma mb; the operands err by (ca + cb + ca cb u) u P and rounding adds
// u P + u N. With fl(P) >= P (1 - u) - u N this is at most c u (fl(P) + N): the N inside every product pays
// for its underflow, however large the factors are that it meets later. (One threshold on the final magnitude
// would not: mixed exponents.)
//
// The last operation is a sum, and rounding it cannot change its sign, so its own + 1 is not owed. The test
// |x'| > fl(K m) implies |x'| > K m, since x' is representable and rounding is monotone; so not even K m may
// spoil it by underflow. Overflow makes m infinite or NaN: then nothing compares greater and the caller's
// next stage decides.

/// A coordinate, exact.
struct FilteredCoordinate {
  double value;
};

inline constexpr double smallest_normal = std::numeric_limits<double>::min();

/// A difference of two coordinates: its magnitude is its own.
struct FilteredDifference {
  double value;
  double magnitude() const { return std::fabs(value); }
};

/// A product of two differences: its magnitude is its own and N.
struct FilteredProduct {
  double value;
  double magnitude() const { return std::fabs(value) + smallest_normal; }
};

/// Any other value, with its magnitude.
struct FilteredValue {
  double value, bound;
  double magnitude() const { return bound; }
};

template <class Number>
concept Filterable = requires(Number a) {
  a.value + a.magnitude();
};

inline FilteredDifference operator-(FilteredCoordinate a, FilteredCoordinate b) {
  return {a.value - b.value};
}

inline FilteredProduct operator*(FilteredDifference a, FilteredDifference b) { return {a.value * b.value}; }
template <Filterable Left, Filterable Right>
FilteredValue operator*(Left a, Right b) {
  return {a.value * b.value, a.magnitude() * b.magnitude() + smallest_normal};
}

// Two products of differences in a sum make do with one N, for each owes 3 u P + u N by itself, both 3 u (P +
// Q) + 2 u N, and 2 < 3.
inline FilteredValue operator+(FilteredProduct a, FilteredProduct b) {
  return {a.value + b.value, std::fabs(a.value) + b.magnitude()};
}
inline FilteredValue operator-(FilteredProduct a, FilteredProduct b) {
  return {a.value - b.value, std::fabs(a.value) + b.magnitude()};
}
template <Filterable Left, Filterable Right>
FilteredValue operator+(Left a, Right b) {
  return {a.value + b.value, a.magnitude() + b.magnitude()};
}
template <Filterable Left, Filterable Right>
FilteredValue operator-(Left a, Right b) {
  return {a.value - b.value, a.magnitude() + b.magnitude()};
}

namespace detail {

/// The coefficient c of the derivation, and what is owed when this is the last operation.
struct ErrorCoefficient {
  double rounded, unrounded;
};
struct ExactCoordinate {};

/// Covers the (1 + O(u)) factors of one operation and the rounding of c itself, as long as c < 2^10.
constexpr double enlarged(double c) { return c * (1 + 0x1p-42); }

constexpr ErrorCoefficient operator-(ExactCoordinate, ExactCoordinate) { return {1, 0}; }
constexpr ErrorCoefficient operator*(ErrorCoefficient a, ErrorCoefficient b) {
  const double c = enlarged(a.rounded + b.rounded + 1);
  return {c, c};
}
constexpr ErrorCoefficient operator+(ErrorCoefficient a, ErrorCoefficient b) {
  const double c = enlarged(a.rounded > b.rounded ? a.rounded : b.rounded);
  return {enlarged(c + 1), c};
}
constexpr ErrorCoefficient operator-(ErrorCoefficient a, ErrorCoefficient b) { return a + b; }

}  // namespace detail

/// K of the derivation for a formula whose last operation is a sum.
template <class Formula>
constexpr double error_coefficient =
    detail::enlarged(Formula::determinant(Arguments<detail::ExactCoordinate, Formula>{}).unrounded) * 0x1p-53;

namespace detail {
constexpr bool is_nearly(double coefficient, double units) {
  return units * 0x1p-53 < coefficient && coefficient < units * 0x1p-53 * (1 + 0x1p-36);
}
}  // namespace detail

// To first order the propagation finds what Shewchuk 1997 derived by hand for his stage A.
static_assert(detail::is_nearly(error_coefficient<Orient<2>>, 3));
static_assert(detail::is_nearly(error_coefficient<Orient<3>>, 7));
static_assert(detail::is_nearly(error_coefficient<InSphere<2>>, 10));
static_assert(detail::is_nearly(error_coefficient<InSphere<3>>, 16));

/// A coordinate of which only the width of its box is known.
struct BoxCoordinate {
  double width;
};
inline FilteredDifference operator-(BoxCoordinate a, BoxCoordinate) { return {a.width}; }

/// A threshold for all queries with points in a box of that width: where the determinant, computed in
/// floating point as written, is greater in magnitude, its sign is right. Magnitudes grow with the
/// differences, and so does their rounding; hence K m is greatest when every difference is as large as can
/// be, and this is K m then. Infinite or NaN where it overflows: then nothing is greater.
template <class Formula>
double error_bound_in_box(double width) {
  Arguments<BoxCoordinate, Formula> arguments;
  for (auto& point : arguments) point.fill({width});
  return error_coefficient<Formula> * Formula::determinant(arguments).magnitude();
}

/// The sign of the determinant where one pass of floating-point arithmetic proves it; zero says "not proven",
/// never "is zero". Sound for all finite doubles under round-to-nearest with subnormals. Without branches.
template <class Formula>
inline Sign filtered_sign(const Query<Formula>& query) {
  const auto d = Formula::determinant(
      convert_arguments<FilteredCoordinate, Formula>(query, [](double c) { return FilteredCoordinate{c}; }));
  const double error = error_coefficient<Formula> * d.magnitude();
  return sign_beyond(d.value, error);
}

}  // namespace tribunal
