// A filter for integers of known size: one constant bounds the rounding error of the whole formula.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"

#include <cmath>
#include <limits>

namespace tribunal {

// Derivation (Fortune and Van Wyk 1993). Differences of coordinates are integers d, |d| < 2^b <= 2^53, and
// exact. Each value x of the formula is computed as x' with |x|, |x'| <= m and |x' - x| <= e, all known at
// compile time:
//
//   difference   m = 2^b         e = 0
//   sum          m = ma + mb     e = ea + eb + r(m)
//   product      m = ma mb       e = ma eb + mb ea + r(m)
//
// where r(m), the error of rounding a value that is at most m, is 0 for m <= 2^53 (an integer, hence exact)
// and u m beyond. Each m is a small integer times a power of two, hence representable, and since rounding is
// monotone it bounds x' as well as x. No product underflows, for the smallest nonzero magnitude is 1.

namespace detail {

struct StaticCoordinate {
  int bits;  ///< of the differences between two of them
};

struct StaticValue {
  double magnitude, error;
};

constexpr double rounding_of(double magnitude) { return magnitude <= 0x1p53 ? 0 : magnitude * 0x1p-53; }

constexpr StaticValue operator-(StaticCoordinate a, StaticCoordinate) { return {power_of_two(a.bits), 0}; }
constexpr StaticValue operator+(StaticValue a, StaticValue b) {
  const double magnitude = a.magnitude + b.magnitude;
  return {magnitude, a.error + b.error + rounding_of(magnitude)};
}
constexpr StaticValue operator-(StaticValue a, StaticValue b) { return a + b; }
constexpr StaticValue operator*(StaticValue a, StaticValue b) {
  const double magnitude = a.magnitude * b.magnitude;
  return {magnitude, a.magnitude * b.error + b.magnitude * a.error + rounding_of(magnitude)};
}

template <class Formula>
constexpr StaticValue static_value(int bits) {
  Arguments<StaticCoordinate, Formula> arguments;
  for (auto& point : arguments) point.fill({bits});
  return Formula::determinant(arguments);
}

// Single precision's 24 bits leave orientation exact; at 53 bits incircle errs by up to 2^165.3.
static_assert(static_value<Orient<2>>(24).error == 0 && static_value<Orient<2>>(28).error == 0x1p5);
static_assert(static_value<Orient<2>>(36).error == 0x1p21 && static_value<Orient<2>>(53).error == 0x1p55);
static_assert(static_value<Orient<2>>(26).error == 0 && static_value<Orient<2>>(27).error == 0x1p3);
static_assert(static_value<InSphere<2>>(12).error == 0 && static_value<InSphere<2>>(24).error == 0x1p48);
static_assert(static_value<InSphere<2>>(28).error == 0x5p63 &&
              static_value<InSphere<2>>(53).error == 0x5p163);
static_assert(static_value<Orient<3>>(16).error == 0 && static_value<Orient<3>>(24).error == 0x1p23);

}  // namespace detail

/// The largest error of the determinant in double precision when coordinate differences are integers below
/// 2^bits, bits <= 53; 0 when no intermediate value is ever rounded.
template <class Formula>
constexpr double static_error_bound(int bits) {
  return detail::static_value<Formula>(bits).error * (1 + 0x1p-40);  // its own arithmetic rounds, too
}

/// The same for differences that are multiples of 2^exponent, below 2^(bits + exponent). A formula that is
/// homogeneous of the given degree scales; only where it could underflow or overflow on the way there is no
/// bound, and infinity certifies nothing.
template <class Formula>
double static_error_bound(int bits, int exponent, int degree) {
  constexpr int largest = std::numeric_limits<double>::max_exponent - 1;
  constexpr int smallest = std::numeric_limits<double>::min_exponent - 1;
  const int scale = degree * exponent;
  const int magnitude_exponent = std::ilogb(detail::static_value<Formula>(bits).magnitude) + 1;
  if (scale < smallest || magnitude_exponent + scale > largest)
    return std::numeric_limits<double>::infinity();
  return std::ldexp(static_error_bound<Formula>(bits), scale);
}

}  // namespace tribunal
