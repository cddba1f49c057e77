// The triangulation from which the points of `lawson-worst-case` need quadratically many flips.
#pragma once

#include "algorithms/triangulation.hpp"

#include <vector>

namespace tribunal::bench {

/// Upper vertices U_i = i and lower ones L_i = m + i, 0 <= i < m. Between the chains all upper ones are
/// joined to L_0 and all lower ones to U_{m-1}, the longest diagonals there are; the pockets behind them are
/// fans from U_0 and L_0. Counter-clockwise.
inline std::vector<Triangle> facing_chains_start(Index m) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i + 1 < m; ++i) {
    triangles.push_back({m, i + 1, i});
    triangles.push_back({m - 1, m + i, m + i + 1});
    if (i == 0) continue;
    triangles.push_back({0, i, i + 1});
    triangles.push_back({m, m + i + 1, m + i});
  }
  return triangles;
}

}  // namespace tribunal::bench
