// Experiment `scopes`: the expected tau of a point set, exactly, from the scopes of its circles.
#pragma once

#include "bench/experiments/experiment.hpp"

namespace tribunal::bench {

/// T_j is the number of triples whose open circumdisk (scope) holds j of the N sites. A triple becomes a
/// triangle, at the moment its last corner is inserted, if its corners come before the sites in its scope, so
/// that over uniformly random orders
///     E[tau] = sum_{j=0}^{N-3} P(j) T_j,   P(j) = 3! j! / (j+3)! = 6 / ((j+1)(j+2)(j+3)).
/// By brute force over triples, N^4 / 24 circle tests: at most 60 distinct sites, else `refused_input`.
///
/// Counters: `T.0` ..., `tau_expected`, `tau_bound` = 6N - 15 H_N + 21/2 (Barth, eq. 3.3.0), `sites`, `hull`;
/// `collinear` triples and `cocircular` quadruples seen (a quadruple counts once for each of its triples).
/// Where both are zero:
/// - `residual_reflection`: max_j |T_j + T_{N-3-j} - 2(j+1)(N-2-j)| is 0;
/// - `residual_sets`: max_j |T_j - (j+1)(2N-j-2) + sum_{i=1}^{j+1} S_i| is 0, S_i the directed pairs with i-1
/// sites on
///   their right;
/// - `residual_ends`: |T_0 - (2N-2-h)| + |T_{N-3} - (h-2)| is 0;
/// - `violations_upper`: the j <= N/3 - 1 with T_j > (j+1)(2N - 5j/2 - 5) are none.
Finding run_scopes(const Cell& cell);

inline constexpr Experiment scopes_experiment{
    .name = "scopes",
    .cites = "Guibas, Knuth, Sharir 1992",
    .summary =
        "expected tau over all insertion orders, exactly, from the number of sites in every circumcircle",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_scopes,
};

}  // namespace tribunal::bench
