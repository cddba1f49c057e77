// Integers of unbounded size (GMP), as a value type.
#pragma once

#include "predicates/sign.hpp"

#include <gmpxx.h>

#include <cmath>

namespace tribunal {

/// GMP's operators return expression templates that dangle behind `auto`; these evaluate at once, so that a formula
/// may name its intermediate results.
struct BigInteger {
  mpz_class value;

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) { return {a.value + b.value}; }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return {a.value - b.value}; }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) { return {a.value * b.value}; }
};

inline Sign sign_of(const BigInteger& a) { return static_cast<Sign>(sgn(a.value)); }

/// The exponent e of the least significant set bit of x, so that x * 2^-e is an odd integer; x finite and not zero.
inline int lowest_bit_exponent(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // |fraction| in [1/2, 1), 53 bits
  const auto mantissa = static_cast<long long>(std::ldexp(fraction, 53));
  return exponent - 53 + __builtin_ctzll(static_cast<unsigned long long>(mantissa));
}

/// x * 2^-exponent, which must be an integer.
inline BigInteger scaled_integer(double x, int exponent) {
  if (x == 0) return {};
  int own = 0;
  const double fraction = std::frexp(x, &own);
  BigInteger result{mpz_class(std::ldexp(fraction, 53))};
  const int shift = own - 53 - exponent;
  if (shift >= 0)
    mpz_mul_2exp(result.value.get_mpz_t(), result.value.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
  else
    mpz_tdiv_q_2exp(result.value.get_mpz_t(), result.value.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
  return result;
}

}  // namespace tribunal
