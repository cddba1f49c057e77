// Normally distributed numbers without logarithms or sines, whose last bits differ between mathematical
// libraries.
#pragma once

#include "datasets/random.hpp"

namespace tribunal::generators {

/// True with probability exp(-x), 0 <= x <= 1: a run x > u1 > u2 > ... of uniform numbers has even length
/// with the probability 1 - x + x^2/2! - ... (von Neumann 1951).
constexpr bool with_probability_exp_minus(double x, Random& random) {
  bool even = true;
  double u = random.unit();
  while (u < x) {
    x = u;
    u = random.unit();
    even = !even;
  }
  return even;
}

/// A number of the standard normal distribution, by comparisons of uniform numbers alone (Karney 2016,
/// algorithm N): integer part k with weight exp(-k^2/2), fraction x with weight exp(-x(2k + x)/2), then a
/// sign.
constexpr double gaussian(Random& random) {
  for (;;) {
    int k = 0;
    while (with_probability_exp_minus(0.5, random)) ++k;
    bool accepted = true;
    for (int i = 0; i < k * (k - 1) && accepted; ++i) accepted = with_probability_exp_minus(0.5, random);
    const double x = random.unit();
    // In k + 1 equal parts, so that each exponent is at most 1.
    for (int i = 0; i <= k && accepted; ++i)
      accepted = with_probability_exp_minus(x * (2 * k + x) / (2 * k + 2), random);
    if (accepted) return (random.bits() & 1) != 0 ? k + x : -(k + x);
  }
}

}  // namespace tribunal::generators
