// The grid that a point set lives on: what makes its predicates integer arithmetic.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/domain.hpp"
#include "predicates/kernel.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace tribunal {

/// All multiples of 2^exponent in a box so narrow that coordinate differences are integers below 2^bits times
/// 2^exponent. With bits <= 53 those differences are exact in double precision, wherever the box lies.
class Lattice {
 public:
  static constexpr int most_bits = 53;
  /// Within these, 2^exponent and its inverse are normal numbers. No coarser lattice is ever needed: a
  /// difference that does not overflow is less than 2^53 times 2^971.
  static constexpr int smallest_exponent = -1022, largest_exponent = 971;

  /// The coarsest lattice of the points, or the first point that fits none with the points before it. O(n).
  template <int D>
  static Binding<Lattice> find(std::span<const Point<D>> points);

  int exponent() const { return exponent_; }
  int bits() const { return bits_; }
  /// 2^-exponent: multiplies a difference to an integer.
  double inverse_unit() const { return power_of_two(-exponent_); }

  /// Whether p, bound or not, is a lattice point of the points' box. False for NaN.
  template <int D>
  bool contains(const Point<D>& p) const {
    for (int axis = 0; axis < D; ++axis) {
      const auto& [lowest, highest] = box_[axis];
      if (!(lowest <= p[axis] && p[axis] <= highest && is_multiple(p[axis]))) return false;
    }
    return true;
  }

 private:
  struct Interval {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
  };

  /// Bit length of the largest difference in units, most_bits + 1 for all that are longer.
  int measure() const {
    double widest = 0;
    for (const Interval& interval : box_) widest = std::max(widest, interval.highest - interval.lowest);
    // Rounding is monotone, so a width of 2^53 units or more cannot round to less; a smaller one is exact.
    const double units = widest * inverse_unit();
    if (!(units < 0x1p53)) return most_bits + 1;
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(units)));
  }

  bool is_multiple(double x) const {
    const double units = x * inverse_unit();
    if (!(std::fabs(units) < 0x1p53)) return true;  // too large for a fraction, even where it overflowed
    // Compared in the scale of x: a tiny one may have underflowed to 0 units.
    return static_cast<double>(static_cast<std::int64_t>(units)) * power_of_two(exponent_) == x;
  }

  std::array<Interval, 3> box_;  // in the plane the last one stays empty
  int exponent_ = largest_exponent;
  int bits_ = 0;
};

template <int D>
Binding<Lattice> Lattice::find(std::span<const Point<D>> points) {
  static_assert(D <= 3);
  if (auto refusal = refuse_environment()) return *refusal;
  Lattice lattice;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) return Refusal{i, "a coordinate is not finite"};
    for (int axis = 0; axis < D; ++axis) {
      const double x = points[i][axis];
      Interval& interval = lattice.box_[axis];
      interval = {std::min(interval.lowest, x), std::max(interval.highest, x)};
      if (x != 0) lattice.exponent_ = std::min(lattice.exponent_, to_dyadic(x).exponent);
      if (lattice.exponent_ < smallest_exponent)
        return Refusal{i, name_coordinate(axis, x) + " is no multiple of 2^-1022"};
      lattice.bits_ = lattice.measure();
      if (lattice.bits_ > most_bits)
        return Refusal{i,
                       name_coordinate(axis, x) +
                           " makes coordinate differences longer than 53 bits on the points' common lattice"};
    }
  }
  return lattice;
}

}  // namespace tribunal
