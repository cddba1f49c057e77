// Doubles with every sum of products contracted to fused multiply-adds, as a compiler may do when it is
// allowed to.
#pragma once

#include "predicates/sign.hpp"

#include <cmath>

namespace tribunal {

/// A rounded number.
struct Fused {
  double value;
};

/// A product not rounded yet: it waits for a sum to be fused with.
struct FusedProduct {
  double left, right;
  Fused rounded() const { return {left * right}; }
};

inline Fused operator-(Fused a, Fused b) { return {a.value - b.value}; }
inline Fused operator+(Fused a, Fused b) { return {a.value + b.value}; }
inline FusedProduct operator*(Fused a, Fused b) { return {a.value, b.value}; }
inline FusedProduct operator*(FusedProduct a, Fused b) { return a.rounded() * b; }
inline FusedProduct operator*(Fused a, FusedProduct b) { return a * b.rounded(); }

inline Fused operator+(FusedProduct a, Fused b) { return {std::fma(a.left, a.right, b.value)}; }
inline Fused operator+(Fused a, FusedProduct b) { return b + a; }
inline Fused operator-(FusedProduct a, Fused b) { return {std::fma(a.left, a.right, -b.value)}; }
inline Fused operator-(Fused a, FusedProduct b) { return {std::fma(-b.left, b.right, a.value)}; }

/// Of two products only one is fused; the other rounds first. Hence a b - b a need not be zero.
inline Fused operator+(FusedProduct a, FusedProduct b) { return a + b.rounded(); }
inline Fused operator-(FusedProduct a, FusedProduct b) { return a - b.rounded(); }

inline Sign sign_of(Fused a) { return sign_of(a.value); }

}  // namespace tribunal
