// Experiment `knuth-printed`: the sign test of three products as the source prints it, on trial.
#pragma once

#include "bench/experiments/experiment.hpp"

#include <array>

namespace tribunal::bench {

/// The sign of x0 y0 + x1 y1 + x2 y2 by the program printed in Barth's section 3.7, by variants of it with
/// one kind of misprint each, and by the corrected one, against 64-bit integers.
///
/// Two witnesses, for the product that overwrites instead of adding up and for the carry that does:
/// x = (-1,-1,1), y = (0,1,1) and x = (19317,1444,-18836), y = (24311,26904,14696). Counters
/// `witness.<i>.exact`,
/// `.printed` and `.corrected` hold their signs as -1, 0, 1.
///
/// Then n random cases, |x_i| < 2^28, 0 <= y_i < 2^28: `uniform`, or `near-cancelling` where x2 is the
/// rounded quotient
/// -(x0 y0 + x1 y1) / y2 plus -1, 0 or 1 (cases out of range are drawn anew). Counters `queries`, `zeros` and
/// `wrong.printed`, `wrong.third_product`, `wrong.carry`, `wrong.late_exits`, `wrong.corrected`,
/// `wrong.redundant` (the backend `knuth`'s own).
Finding run_knuth_printed(const Cell& cell);

namespace knuth_printed {
inline constexpr Parameter generator{
    .name = "generator", .summary = "how the cases are drawn", .standard = "uniform", .choices = [] {
      return std::vector<std::string_view>{"uniform", "near-cancelling"};
    }};
inline constexpr std::array parameters{generator};
}  // namespace knuth_printed

inline constexpr Experiment knuth_printed_experiment{
    .name = "knuth-printed",
    .cites = "Barth, section 3.7; Knuth 1993",
    .summary =
        "wrong signs of the printed multiple-precision sign test, by misprint, with a witness for each",
    .reads = {.n = true, .seed = true},
    .parameters = knuth_printed::parameters,
    .run = run_knuth_printed,
};

}  // namespace tribunal::bench
