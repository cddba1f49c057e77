// The bound on the expected number of triangles that random insertion makes.
#pragma once

#include <cstdint>

namespace tribunal::bench {

/// 6N - 15 H_N + 21/2, H_N the N-th harmonic number (Barth, eq. 3.3.0). It bounds the expectation of tau over
/// uniformly random orders, N >= 3; single runs may exceed it. O(N).
inline double tau_bound(std::uint64_t n) {
  double harmonic = 0;
  for (std::uint64_t i = n; i > 0; --i) harmonic += 1 / static_cast<double>(i);  // small terms first
  return 6 * static_cast<double>(n) - 15 * harmonic + 10.5;
}

}  // namespace tribunal::bench
