// The closed forms that claims about counts are measured against.
#pragma once

#include <cstdint>
#include <string_view>

namespace tribunal::reports {

/// H_N = 1 + 1/2 + ... + 1/N. O(N).
double harmonic(std::uint64_t n);

/// A bound on, or the value of, an expected count for N sites inserted in uniformly random order.
struct Bound {
  std::string_view name;
  std::string_view formula;  ///< as the reader sees it
  double (*at)(std::uint64_t n);
};

/// The bound of that name, or null. Known are
/// "tau": 6N - 15 H_N + 21/2, Barth eq. (3.3.0). Backward analysis: the site inserted i-th is any of the
/// first i with
///   equal chance, so 3 T_0(i)/i = 6 - (6 + 3h_i)/i finite triangles meet it on average, h_i sites on the
///   hull; h_i >= 3 and summing i = 3..N give it.
/// "tau-with-ghosts": 6N - 9 H_N + 3/2: the ghost triangles counted too, 6 - (6 + h_i)/i per site.
/// "created": 9N: all triangles ever made, those that later flips of the same insertion remove included
/// (Guibas, Knuth
///   and Sharir 1992).
/// "tau-uniform": not a bound but the value for sites uniform in a square, with the hull's expected size
///   h_i = 8/3 (ln i + gamma - ln 2) of Renyi and Sulanke (1963), never below 3.
const Bound* find_bound(std::string_view name);

}  // namespace tribunal::reports
