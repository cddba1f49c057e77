#include "predicates/environment.hpp"

#include <limits>

namespace tribunal {

FloatingPointWitness witness_floating_point() {
  // Volatile operands keep the compiler from folding the very operations that are to be seen at work.
  volatile const double a = 1 + 0x1p-30, c = 1, d = 1 + 0x1p-29;
  // a*a = 1 + 2^-29 + 2^-60 rounds to d; fused, the difference is 2^-60.
  const double x = a, y = c, z = d;
  const bool no_contraction = x * x - y * z == 0;

  volatile const double one = 1, half_ulp = 0x1p-53, three_quarters = 0x1.8p-53;
  const bool nearest = one + half_ulp == 1 && one + three_quarters == 1 + 0x1p-52 && -one - half_ulp == -1;

  volatile const double smallest_normal = std::numeric_limits<double>::min();
  volatile const double half = smallest_normal / 2;
  const bool subnormals = half != 0 && half + half == smallest_normal;

  volatile const double big = 0x1p53;
  const bool double_precision = (big + 1) - big == 0;
  return {no_contraction, nearest, subnormals, double_precision};
}

std::string describe_fault(const FloatingPointWitness& witness) {
  // First, for another rounding mode looks like contraction, too.
  if (!witness.round_to_nearest) return "the rounding mode is not to nearest";
  if (!witness.no_contraction) return "products and sums are contracted to fused multiply-adds";
  if (!witness.subnormals) return "subnormal numbers are flushed to zero";
  if (!witness.double_precision) return "expressions are evaluated in extended precision";
  return {};
}

}  // namespace tribunal
