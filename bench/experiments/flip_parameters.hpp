// Parameters of the experiments that flip edges.
#pragma once

#include "algorithms/flips/lawson.hpp"
#include "bench/experiments/experiment.hpp"

namespace tribunal::bench {

constexpr Parameter start_parameter{
    .name = "start", .summary = "the triangulation to start from", .standard = "sweep", .choices = [] {
      return std::vector<std::string_view>{"sweep", "fan"};
    }};
constexpr Parameter random_flips_parameter{.name = "random_flips",
                                           .summary = "random flips tried per site before that",
                                           .standard = "0",
                                           .least = 0,
                                           .most = 1000};
constexpr Parameter method_parameter{
    .name = "method", .summary = "which edges are tested again", .standard = "stack", .choices = [] {
      return std::vector<std::string_view>{"stack", "sweeps"};
    }};
constexpr Parameter scan_parameter{
    .name = "scan", .summary = "the order of a sweep", .standard = "ascending", .choices = [] {
      return std::vector<std::string_view>{"ascending", "descending", "shuffled"};
    }};

/// The cell's values of method and scan; its seed draws random flips and shuffled sweeps.
inline FlipOptions sweep_options(const Cell& cell) {
  const std::string scan = choice(cell, scan_parameter);
  return {.method = choice(cell, method_parameter) == "sweeps" ? Method::sweeps : Method::stack,
          .scan = scan == "ascending"    ? Scan::ascending
                  : scan == "descending" ? Scan::descending
                                         : Scan::shuffled,
          .seed = cell.seed};
}

/// And of all four.
inline FlipOptions flip_options(const Cell& cell) {
  FlipOptions options = sweep_options(cell);
  options.start = choice(cell, start_parameter) == "fan" ? Start::fan : Start::sweep;
  options.random_flips = whole_number(cell, random_flips_parameter);
  return options;
}

}  // namespace tribunal::bench
