// A box of a lattice in which coordinates are 64-bit integers: what lets the exact stage start at once.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace tribunal {

/// All multiples of 2^exponent in a box whose corners are less than 2^61 of them away from zero. Counted from
/// the lowest corner, they are integers below 2^bits, bits <= 62, and so are their differences in magnitude.
class IntegerFrame {
 public:
  /// The frame of the coarsest lattice of the points, which must be finite; nothing where they need more
  /// bits. O(n).
  template <int D>
  static std::optional<IntegerFrame> find(std::span<const Point<D>> points);

  int bits() const { return static_cast<int>(std::bit_width(width_)); }

  /// The coordinates of the query's points, counted; false when one of them is no lattice point of the box.
  template <class Formula>
  bool count(const Query<Formula>& query, Arguments<std::int64_t, Formula>& counts) const {
    bool inside = true;
    for (int i = 0; i < Formula::points; ++i)
      for (int axis = 0; axis < Formula::dimension; ++axis) {
        const double x = query[i][axis];
        // Clamped, for the conversion of what an int64 does not hold is undefined; NaN is clamped, too.
        const double units = std::max(-farthest, std::min(farthest, x * inverse_unit_));
        const auto integer = static_cast<std::int64_t>(units);
        // Compared in the scale of x: a tiny one may have underflowed to 0 units.
        const bool is_multiple = static_cast<double>(integer) * unit_ == x;
        counts[i][axis] = integer - lowest_[axis];
        inside &= is_multiple & (static_cast<std::uint64_t>(counts[i][axis]) <= width_);
      }
    return inside;
  }

 private:
  static constexpr double farthest = 0x1p61;

  explicit IntegerFrame(int exponent)
      : unit_(power_of_two(exponent)), inverse_unit_(power_of_two(-exponent)) {}

  double unit_, inverse_unit_;
  std::array<std::int64_t, 3> lowest_{};
  std::uint64_t width_ = 0;  ///< of the widest side
};

template <int D>
std::optional<IntegerFrame> IntegerFrame::find(std::span<const Point<D>> points) {
  static_assert(D <= 3);
  // Within these, 2^exponent and its inverse are normal numbers.
  constexpr int smallest_exponent = -1022, largest_exponent = 1022;
  int exponent = largest_exponent;
  std::array<double, D> lowest, highest;
  lowest.fill(std::numeric_limits<double>::infinity());
  highest.fill(-std::numeric_limits<double>::infinity());
  for (const Point<D>& p : points)
    for (int axis = 0; axis < D; ++axis) {
      if (p[axis] != 0) exponent = std::min(exponent, to_dyadic(p[axis]).exponent);
      lowest[axis] = std::min(lowest[axis], p[axis]);
      highest[axis] = std::max(highest[axis], p[axis]);
    }
  if (exponent < smallest_exponent) return std::nullopt;
  IntegerFrame frame(exponent);
  for (int axis = 0; axis < D && !points.empty(); ++axis) {
    const double low = lowest[axis] * frame.inverse_unit_, high = highest[axis] * frame.inverse_unit_;
    if (!(-farthest < low && high < farthest)) return std::nullopt;
    frame.lowest_[axis] = static_cast<std::int64_t>(low);
    const auto width = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - frame.lowest_[axis]);
    frame.width_ = std::max(frame.width_, width);
  }
  return frame;
}

}  // namespace tribunal
