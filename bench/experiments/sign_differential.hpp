// Experiment `sign-differential`: how often a backend's sign is wrong, over random queries of a stated kind.
#pragma once

#include "bench/experiments/experiment.hpp"

#include <array>

namespace tribunal::bench {

/// n random queries to one predicate, against exact integers. Coordinates are integers in [-2^(bits-1),
/// 2^(bits-1)), or with bits = 0 such integers of 53 bits times 2^-53. Generators:
/// - `uniform`: all coordinates uniform;
/// - `near-cancelling`: the determinant is zero or next to it. orient2d: a, b = a + m v and c = a + k v, or c
/// off the line
///   by the least that the lattice has, so that the determinant is 0 or +-m gcd(v). incircle: four of the
///   eight images of (x, y) under the symmetries of the square about a random centre, the last moved by -1, 0
///   or 1 in x and y;
/// - `grid`: random nodes of an 8 x 8 grid spanned by random vectors (a, b) and (-b, a): many exact zeros, at
/// full length.
///
/// Counters: `queries`, `zeros` (exact), `wrong` = `false_zero` + `inverted` + `false_nonzero`, and
/// `stage.*`, the queries decided by each stage.
Finding run_sign_differential(const Cell& cell);

namespace sign_differential {
inline constexpr Parameter predicate{
    .name = "predicate", .summary = "the predicate asked", .standard = "orient2d", .choices = [] {
      return std::vector<std::string_view>{"orient2d", "incircle"};
    }};
inline constexpr Parameter generator{
    .name = "generator", .summary = "how the queries are drawn", .standard = "uniform", .choices = [] {
      return std::vector<std::string_view>{"uniform", "near-cancelling", "grid"};
    }};
inline constexpr std::array parameters{predicate, generator};
}  // namespace sign_differential

inline constexpr Experiment sign_differential_experiment{
    .name = "sign-differential",
    .cites = "this project",
    .summary = "wrong signs of a backend over n random queries of a stated generator, against exact integers",
    .reads = {.backend = true, .n = true, .bits = true, .seed = true},
    .parameters = sign_differential::parameters,
    .run = run_sign_differential,
};

}  // namespace tribunal::bench
