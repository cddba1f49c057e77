// Experiment `sign-map`: what a backend answers over a fine grid across a line.
#pragma once

#include "bench/experiments/experiment.hpp"

#include <array>

namespace tribunal::bench {

/// orient2d(p + (x, y) 2^-53, q, r) for 0 <= x, y < 256, after the figures of Kettner, Mehlhorn, Pion,
/// Schirra, Yap, "Classroom examples of robustness problems in geometric computations" (2008); the exact
/// signs beside it.
///
/// Counters: `pixels`, `false_zero`, `inverted`, `false_nonzero`. Texts: `signs` and `exact`, the rows y = 0,
/// 1, ... of 256 signs each as one run-length string, a sign (+, -, 0) followed by its run in brackets,
/// "+[12]0[3]-[241]...".
Finding run_sign_map(const Cell& cell);

namespace sign_map {
inline constexpr Parameter figure{
    .name = "figure", .summary = "which of the three point triples", .standard = "2a", .choices = [] {
      return std::vector<std::string_view>{"2a", "2b", "2c"};
    }};
inline constexpr std::array parameters{figure};
}  // namespace sign_map

inline constexpr Experiment sign_map_experiment{
    .name = "sign-map",
    .cites = "Kettner et al. 2008",
    .summary =
        "orientation signs of a backend on a 256 x 256 grid of neighbouring doubles, against the exact ones",
    .reads = {.backend = true},
    .parameters = sign_map::parameters,
    .run = run_sign_map,
};

}  // namespace tribunal::bench
