// Intervals of doubles that enclose the true value whatever the rounding did, without touching the rounding
// mode.
#pragma once

#include "predicates/sign.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace tribunal {

// Derivation. Rounding to nearest leaves the true result within half a step of the computed one, between its
// two neighbours; so a computed end moved outwards by one step bounds the true end. This holds where results
// are subnormal (there the steps are all equal), where they underflow to zero, and where they overflow: what
// rounds to infinity is still greater than the largest double. Of a sum the error itself is known (Knuth's
// two-sum, exact under gradual underflow), so that an end moves only when it was rounded inwards: exact
// differences stay exact. (Near overflow the error may come out NaN; then both ends move.)
//
// An interval is finite or the whole line. Whatever leaves the finite numbers on the way, infinities and the
// NaN of inf - inf or 0 inf alike, gives the whole line; a comparison with it certifies nothing.

/// All x with low <= x <= high; a coordinate is converted to a single point.
class Interval {
 public:
  constexpr Interval() = default;
  constexpr explicit Interval(double x) : low_(x), high_(x) {}
  constexpr double low() const { return low_; }
  constexpr double high() const { return high_; }

  friend Interval operator+(const Interval& a, const Interval& b) {
    const double low = a.low_ + b.low_, high = a.high_ + b.high_;
    const double low_error = sum_error(a.low_, b.low_, low), high_error = sum_error(a.high_, b.high_, high);
    return enclosing(low_error >= 0 ? low : below(low), high_error <= 0 ? high : above(high));
  }
  friend Interval operator-(const Interval& a, const Interval& b) { return a + Interval(-b.high_, -b.low_); }
  friend Interval operator*(const Interval& a, const Interval& b) {
    const double p = a.low_ * b.low_, q = a.low_ * b.high_, r = a.high_ * b.low_, s = a.high_ * b.high_;
    return enclosing(below(std::min(std::min(p, q), std::min(r, s))),
                     above(std::max(std::max(p, q), std::max(r, s))));
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  constexpr Interval(double low, double high) : low_(low), high_(high) {}

  /// The whole line unless both ends are finite. A product with the whole line always comes here with one
  /// that is not: its p above is infinite or NaN, and min and max return their first argument where nothing
  /// compares less.
  static Interval enclosing(double low, double high) {
    return std::isfinite(low) && std::isfinite(high) ? Interval(low, high) : Interval(-infinity, infinity);
  }
  static double sum_error(double a, double b, double sum) {
    const double from_b = sum - a, from_a = sum - from_b;
    return (a - from_a) + (b - from_b);
  }
  /// The next double above x. Those of one sign are ordered as their bits are.
  static double above(double x) {
    if (x == 0) return std::numeric_limits<double>::denorm_min();
    const auto bits = std::bit_cast<std::int64_t>(x);
    return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
  }
  static double below(double x) { return -above(-x); }

  double low_ = 0, high_ = 0;
};

/// The sign of whatever the interval encloses, where that is the same for all of it.
inline std::optional<Sign> certain_sign(const Interval& a) {
  if (a.low() > 0) return Sign::positive;
  if (a.high() < 0) return Sign::negative;
  if (a.low() == 0 && a.high() == 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace tribunal
