// A lattice on which coordinates become integers in three operations: what lets the exact stage start at
// once.
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

/// All multiples of 2^exponent that are less than 2^51 of them away from zero, counted from a corner of the
/// data. In the data's box counts are below 2^bits, and so are their differences in magnitude.
class IntegerFrame {
 public:
  static constexpr int most_bits = 51;

  /// The frame of the coarsest lattice of the points, which must be finite; nothing without points, or where
  /// one is 2^50 units away from zero: the rest is room for the points of their WorkingBox. O(n).
  template <int D>
  static std::optional<IntegerFrame> find(std::span<const Point<D>> points);

  int bits() const { return static_cast<int>(std::bit_width(width_)); }

  /// The coordinates of the query's points, counted; false when one of them is off the lattice or out of the
  /// box. The points must lie in the data's WorkingBox.
  ///
  /// Between 2^52 and 2^53 units doubles are the whole numbers of units. Adding 1.5 * 2^52 moves a coordinate
  /// there: it comes back unchanged if and only if nothing was rounded, and in between its last bits are the
  /// count.
  template <class Formula>
  bool count(const Query<Formula>& query, Arguments<std::int64_t, Formula>& counts) const {
    unsigned outside = 0;  // counted, not branched on
    for (int i = 0; i < Formula::points; ++i)
      for (int axis = 0; axis < Formula::dimension; ++axis) {
        const double moved = query[i][axis] + shift_;
        counts[i][axis] = std::bit_cast<std::int64_t>(moved) - lowest_[axis];
        outside += moved - shift_ != query[i][axis];
        outside += static_cast<std::uint64_t>(counts[i][axis]) > width_;
      }
    return outside == 0;
  }

 private:
  explicit IntegerFrame(int exponent) : shift_(std::ldexp(0x1.8p52, exponent)) {}

  double shift_;
  std::array<std::int64_t, 3> lowest_{};  ///< the bits of the least coordinates, moved
  std::uint64_t width_ = 0;               ///< of the widest side
};

template <int D>
std::optional<IntegerFrame> IntegerFrame::find(std::span<const Point<D>> points) {
  static_assert(D <= 3);
  if (points.empty()) return std::nullopt;
  int exponent = std::numeric_limits<double>::max_exponent - 1 - 53;  // the shift has to be finite
  std::array<double, D> lowest, highest;
  lowest.fill(std::numeric_limits<double>::infinity());
  highest.fill(-std::numeric_limits<double>::infinity());
  for (const Point<D>& p : points)
    for (int axis = 0; axis < D; ++axis) {
      if (p[axis] != 0) exponent = std::min(exponent, to_dyadic(p[axis]).exponent);
      lowest[axis] = std::min(lowest[axis], p[axis]);
      highest[axis] = std::max(highest[axis], p[axis]);
    }
  IntegerFrame frame(exponent);
  const double farthest = std::ldexp(1, most_bits - 1 + exponent);
  for (int axis = 0; axis < D; ++axis) {
    if (!(-farthest < lowest[axis] && highest[axis] < farthest)) return std::nullopt;
    frame.lowest_[axis] = std::bit_cast<std::int64_t>(lowest[axis] + frame.shift_);
    const auto width = std::bit_cast<std::int64_t>(highest[axis] + frame.shift_) - frame.lowest_[axis];
    frame.width_ = std::max(frame.width_, static_cast<std::uint64_t>(width));
  }
  return frame;
}

}  // namespace tribunal
