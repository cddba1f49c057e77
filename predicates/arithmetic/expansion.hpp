// Exact sums of doubles: a number as the sum of its components, none of which overlaps another (Shewchuk
// 1997).
#pragma once

#include "predicates/arithmetic/fused_multiply_add.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

namespace tribunal {

/// A value and what its rounding lost: exactly the sum or product of two doubles.
struct TwoDoubles {
  double value, error;
};

/// a + b, unless it overflows (Knuth).
inline TwoDoubles two_sum(double a, double b) {
  const double value = a + b, from_b = value - a, from_a = value - from_b;
  return {value, (a - from_a) + (b - from_b)};
}
/// a + b where the exponent of a is no smaller than that of b, or a is zero (Dekker).
inline TwoDoubles fast_two_sum(double a, double b) {
  const double value = a + b;
  return {value, b - (value - a)};
}
/// a * b, unless it overflows or has bits below 2^-1074.
inline TwoDoubles two_product(double a, double b) {
  const double value = a * b;
  return {value, __builtin_fma(a, b, -value)};
}

/// An exact number: the sum of its components, in order of increasing magnitude, without zeros, and
/// nonadjacent: where one has its highest bit, at least one bit is free below the lowest of the next. So the
/// last one has the sign.
///
/// How long can it get? In compressed() each component on the way down is at most an ulp of the one above it:
/// its exponent is less by 52 at least. All are multiples of 2^-1074 below 2^1024, so there are at most 2098
/// / 52 + 1 of them. Operands must keep all products between these (see Adaptive, which scales them so).
///
/// That results are what they are said to be is Shewchuk's Theorems 13 (sum), 19 (scaling) and 23
/// (compression), for rounding to nearest even.
class Expansion {
 public:
  static constexpr int most_components = 2098 / 52 + 1;

  Expansion() = default;
  /// a - b.
  static Expansion difference(double a, double b) {
    Expansion result;
    const TwoDoubles d = two_sum(a, -b);
    if (d.error != 0) result.push_back(d.error);
    if (d.value != 0) result.push_back(d.value);
    return result;
  }

  std::span<const double> components() const { return {component_.data(), static_cast<std::size_t>(size_)}; }

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return compressed(merged(a, b)); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + b.negated(); }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    if (b.size_ > a.size_) return b * a;
    Expansion product;
    for (int i = 0; i < b.size_; ++i) product = compressed(merged(product, scaled(a, b.component_[i])));
    return product;
  }

  friend Sign sign_of(const Expansion& a) {
    return a.size_ == 0 ? Sign::zero : tribunal::sign_of(a.component_[a.size_ - 1]);
  }

 private:
  /// Components in the making: of one expansion scaled and added to another.
  struct Long {
    std::array<double, 3 * most_components> component;
    int size = 0;
    void push_back(double x) {
      if (x != 0) component[size++] = x;
    }
  };

  void push_back(double x) {
    assert(size_ < most_components);
    component_[size_++] = x;
  }
  Expansion negated() const {
    Expansion result;
    for (const double c : components()) result.push_back(-c);
    return result;
  }

  /// Fast-Expansion-Sum: all components of both in order of magnitude, summed upwards, each error kept.
  static Long merged(const auto& a, const auto& b) {
    Long sum;
    int i = 0, j = 0;
    const auto next = [&] {
      const bool from_a = j == size_of(b) || (i < size_of(a) && std::fabs(at(a, i)) < std::fabs(at(b, j)));
      return from_a ? at(a, i++) : at(b, j++);
    };
    const int count = size_of(a) + size_of(b);
    if (count == 0) return sum;
    double rest = next();
    for (int k = 1; k < count; ++k) {
      const TwoDoubles s = two_sum(rest, next());
      sum.push_back(s.error);
      rest = s.value;
    }
    sum.push_back(rest);
    return sum;
  }

  /// Scale-Expansion: every component times b.
  static Long scaled(const Expansion& a, double b) {
    return has_fused_multiply_add() ? scaled_by_instruction(a, b) : scaled_here(a, b);
  }
  TRIBUNAL_FMA [[gnu::flatten]] static Long scaled_by_instruction(const Expansion& a, double b) {
    return scaled_here(a, b);
  }
  static Long scaled_here(const Expansion& a, double b) {
    Long product;
    if (a.size_ == 0) return product;
    TwoDoubles rest = two_product(a.component_[0], b);
    product.push_back(rest.error);
    for (int i = 1; i < a.size_; ++i) {
      const TwoDoubles p = two_product(a.component_[i], b);
      const TwoDoubles low = two_sum(rest.value, p.error);
      product.push_back(low.error);
      rest = fast_two_sum(p.value, low.value);
      product.push_back(rest.error);
    }
    product.push_back(rest.value);
    return product;
  }

  /// Compress: downwards each component takes what fits of those below it, upwards what is left is put in
  /// order.
  static Expansion compressed(Long e) {
    Expansion result;
    if (e.size == 0) return result;
    double rest = e.component[e.size - 1];
    int bottom = e.size;
    for (int i = e.size - 2; i >= 0; --i) {
      const TwoDoubles s = fast_two_sum(rest, e.component[i]);
      rest = s.value;
      if (s.error != 0) {
        e.component[--bottom] = s.value;
        rest = s.error;
      }
    }
    for (int i = bottom; i < e.size; ++i) {
      const TwoDoubles s = fast_two_sum(e.component[i], rest);
      if (s.error != 0) result.push_back(s.error);
      rest = s.value;
    }
    if (rest != 0) result.push_back(rest);
    return result;
  }

  static int size_of(const Expansion& e) { return e.size_; }
  static int size_of(const Long& e) { return e.size; }
  static double at(const Expansion& e, int i) { return e.component_[i]; }
  static double at(const Long& e, int i) { return e.component[i]; }

  std::array<double, most_components> component_;  // of which size_ count
  int size_ = 0;
};

}  // namespace tribunal
