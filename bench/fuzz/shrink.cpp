#include "bench/fuzz/shrink.hpp"

#include "datasets/random.hpp"
#include "predicates/arithmetic/dyadic.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tribunal::bench::fuzz {
namespace {

int bits_of(double x) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(to_dyadic(x).mantissa))));
}

/// x with its mantissa cut to `bits`, towards zero or away from it.
double rounded_to(double x, int bits, bool away) {
  const Dyadic parts = to_dyadic(x);
  const int dropped = bits_of(x) - bits;
  if (dropped <= 0) return x;
  std::int64_t kept = std::abs(parts.mantissa) >> dropped;
  if (away) ++kept;
  return std::copysign(std::ldexp(static_cast<double>(kept), parts.exponent + dropped), x);
}

/// Tries one candidate after the other and keeps those that are smaller and still fail.
class Shrinker {
 public:
  Shrinker(const Case& asked, const std::function<bool(const Case&)>& fails)
      : best_(asked), size_(size_of(asked)), fails_(fails) {}

  Case to_fixpoint() {
    do {
      improved_ = false;
      simplify_points();
      scale();
      shorten_all();
      simplify_numbers();
      if (!improved_) leap();
    } while (improved_);
    return best_;
  }

 private:
  /// Applies `change` to a copy of the best case; true when that is the best one now.
  template <class Change>
  bool attempt(Change change) {
    Case candidate = best_;
    change(candidate);
    const auto numbers = candidate.numbers();
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) return false;
    const CaseSize size = size_of(candidate);
    if (!(size < size_) || !fails_(candidate)) return false;
    best_ = candidate;
    size_ = size;
    return improved_ = true;
  }

  void simplify_points() {
    for (int i = 0; i < best_.points(); ++i) {
      attempt([&](Case& c) { translate(c, i, -1); });
      for (int axis = 0; axis < best_.dimension(); ++axis) attempt([&](Case& c) { translate(c, i, axis); });
      attempt([&](Case& c) { std::fill(c.point(i).begin(), c.point(i).end(), 0.0); });
      for (int j = 0; j < best_.points(); ++j) attempt([&](Case& c) { c.copy_point(j, i); });
    }
    for (int axis = 0; axis < best_.dimension(); ++axis)
      attempt([&](Case& c) {
        for (int i = 0; i < c.points(); ++i) c.point(i)[axis] = -c.point(i)[axis];
      });
  }

  /// Moves point i to the origin, or its coordinate of one axis to zero.
  static void translate(Case& asked, int i, int only_axis) {
    for (int axis = 0; axis < asked.dimension(); ++axis) {
      const double by = asked.point(i)[axis];
      if (only_axis >= 0 && axis != only_axis) continue;
      for (int j = 0; j < asked.points(); ++j) asked.point(j)[axis] -= by;
    }
  }

  /// Multiplies the numbers first, first + stride, ... (count of them) by a power of two that makes one of
  /// them about one.
  void scale_some(std::size_t first, std::size_t stride, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const double reference = best_.numbers()[first + k * stride];
      if (reference == 0) continue;
      const int full = -std::ilogb(reference);
      for (const int exponent : {full, full / 2, (full > 0) - (full < 0)})
        attempt([&](Case& c) {
          for (std::size_t i = 0; i < count; ++i) {
            double& x = c.numbers()[first + i * stride];
            x = std::ldexp(x, exponent);
          }
        });
    }
  }

  void scale() {
    const auto dimension = static_cast<std::size_t>(best_.dimension());
    const auto points = static_cast<std::size_t>(best_.points());
    scale_some(0, 1, best_.size());
    for (std::size_t axis = 0; axis < dimension; ++axis) scale_some(axis, dimension, points);
    for (std::size_t i = 0; i < points; ++i) scale_some(i * dimension, 1, dimension);
  }

  void shorten_all() {
    for (int bits = 1; bits < 53; ++bits)
      attempt([&](Case& c) {
        for (double& x : c.numbers()) x = rounded_to(x, bits, false);
      });
  }

  /// Every candidate for one number is tried for all numbers that equal it, and then for it alone.
  void simplify_numbers() {
    for (std::size_t i = 0; i < best_.size(); ++i) {
      replace(i, 0);
      replace(i, 1);
      for (std::size_t j = 0; j < best_.size(); ++j) replace(i, best_.numbers()[j]);
      for (int bits = 1; bits < bits_of(best_.numbers()[i]); ++bits) {
        replace(i, rounded_to(best_.numbers()[i], bits, false));
        replace(i, rounded_to(best_.numbers()[i], bits, true));
      }
      const double x = best_.numbers()[i];
      if (x == 0) continue;
      const int exponent = -std::ilogb(x);
      for (const int shift : {exponent, exponent / 2, (exponent > 0) - (exponent < 0)})
        replace(i, std::ldexp(x, shift));
      replace(i, -best_.numbers()[i]);
    }
  }

  /// Single steps end in hollows. Where they do, several numbers at once become simple ones, at random but
  /// from the same seed, so that a case this cannot improve stays as it is.
  void leap() {
    constexpr int trials = 4000;
    Random random(1);
    for (int i = 0; i < trials && !improved_; ++i)
      attempt([&](Case& c) {
        for (auto changes = 1 + random.below(c.size()); changes > 0; --changes) {
          double& x = c.numbers()[random.below(c.size())];
          x = simple_number(c, x, random);
        }
      });
  }

  static double simple_number(const Case& asked, double x, Random& random) {
    switch (random.below(6)) {
      case 0:
        return 0;
      case 1:
        return 1;
      case 2:
        return asked.numbers()[random.below(asked.size())];
      case 3:
        return x == 0 ? 1 : rounded_to(x, 1 + static_cast<int>(random.below(3)), random.below(2) == 0);
      case 4:
        return -x;
      default:
        return std::ldexp(1.0, static_cast<int>(random.below(161)) - 80);
    }
  }

  void replace(std::size_t i, double by) {
    const double old = best_.numbers()[i];
    if (old == by && std::signbit(old) == std::signbit(by)) return;
    if (attempt([&](Case& c) { std::replace(c.numbers().begin(), c.numbers().end(), old, by); })) return;
    attempt([&](Case& c) { c.numbers()[i] = by; });
  }

  Case best_;
  CaseSize size_;
  const std::function<bool(const Case&)>& fails_;
  bool improved_ = false;
};

}  // namespace

CaseSize size_of(const Case& asked) {
  CaseSize size{};
  const auto numbers = asked.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double x = numbers[i];
    size.negative += std::signbit(x);
    if (x == 0) continue;
    size.bits += bits_of(x);
    size.exponents += std::abs(std::ilogb(x));
    size.distinct += std::find(numbers.begin(), numbers.begin() + i, x) == numbers.begin() + i;
  }
  return size;
}

Case shrink(const Case& asked, const std::function<bool(const Case&)>& fails) {
  assert(fails(asked));
  return Shrinker(asked, fails).to_fixpoint();
}

}  // namespace tribunal::bench::fuzz
