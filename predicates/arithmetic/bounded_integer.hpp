// Integers that know at compile time how large they can be, and are stored just as wide as that takes.
#pragma once

#include "predicates/arithmetic/fixed_integer.hpp"
#include "predicates/sign.hpp"

#include <bit>

namespace tribunal {

/// An integer of magnitude below Coefficient * 2^(Degree * Bits), as it arises from a homogeneous polynomial
/// of integers below 2^Bits: sums add coefficients, products multiply them and add degrees. So a formula
/// evaluated over these types fixes the width of each of its intermediate values, and none can overflow
/// (Fortune and Van Wyk 1993).
template <int Bits, int Degree = 1, int Coefficient = 1>
struct BoundedInteger {
  static constexpr int bits = Bits, degree = Degree, coefficient = Coefficient;
  /// Of the magnitude; the stored integer has one more for the sign.
  static constexpr int magnitude_bits =
      Degree * Bits + std::bit_width(static_cast<unsigned>(Coefficient - 1));
  using Storage = SignedInteger<magnitude_bits + 1>;
  Storage value;
};

template <int B, int D, int C1, int C2>
constexpr auto operator+(const BoundedInteger<B, D, C1>& a, const BoundedInteger<B, D, C2>& b) {
  using Sum = BoundedInteger<B, D, C1 + C2>;
  using Storage = typename Sum::Storage;
  return Sum{widen<Storage>(a.value) + widen<Storage>(b.value)};
}

template <int B, int D, int C1, int C2>
constexpr auto operator-(const BoundedInteger<B, D, C1>& a, const BoundedInteger<B, D, C2>& b) {
  using Difference = BoundedInteger<B, D, C1 + C2>;
  using Storage = typename Difference::Storage;
  return Difference{widen<Storage>(a.value) - widen<Storage>(b.value)};
}

template <int B, int D1, int D2, int C1, int C2>
constexpr auto operator*(const BoundedInteger<B, D1, C1>& a, const BoundedInteger<B, D2, C2>& b) {
  using Product = BoundedInteger<B, D1 + D2, C1 * C2>;
  return Product{multiply<typename Product::Storage>(a.value, b.value)};
}

template <int B, int D, int C>
constexpr Sign sign_of(const BoundedInteger<B, D, C>& a) {
  return sign_of(a.value);
}

}  // namespace tribunal
