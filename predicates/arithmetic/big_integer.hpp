// Integers of unbounded size (GMP), as a value type.
#pragma once

#include "predicates/arithmetic/dyadic.hpp"
#include "predicates/sign.hpp"

#include <gmpxx.h>

namespace tribunal {

/// GMP's operators return expression templates that dangle behind `auto`; these evaluate at once, so that a
/// formula may name its intermediate results.
struct BigInteger {
  mpz_class value;

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) { return {a.value + b.value}; }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return {a.value - b.value}; }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) { return {a.value * b.value}; }
};

inline Sign sign_of(const BigInteger& a) { return static_cast<Sign>(sgn(a.value)); }

/// x * 2^-exponent, which must be an integer.
inline BigInteger scaled_integer(double x, int exponent) {
  const Dyadic dyadic = to_dyadic(x);
  BigInteger result{mpz_class(static_cast<long>(dyadic.mantissa))};
  if (dyadic.mantissa != 0)
    mpz_mul_2exp(result.value.get_mpz_t(), result.value.get_mpz_t(),
                 static_cast<mp_bitcnt_t>(dyadic.exponent - exponent));
  return result;
}

}  // namespace tribunal
