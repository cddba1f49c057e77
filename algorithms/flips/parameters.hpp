// Parameters of what flips edges: where it starts and how it goes on.
#pragma once

#include "algorithms/flips/lawson.hpp"
#include "algorithms/parameter.hpp"

#include <array>

namespace tribunal {

// The choices stand in the order of the enumerators.

constexpr Parameter start_parameter{
    .name = "start", .summary = "the triangulation to start from", .standard = "sweep", .choices = [] {
      return std::vector<std::string_view>{"sweep", "fan", "halves"};
    }};
constexpr Parameter random_flips_parameter{.name = "random-flips",
                                           .summary = "random flips tried per site before that",
                                           .standard = "0",
                                           .least = 0,
                                           .most = 1000};
constexpr Parameter method_parameter{.name = "method",
                                     .summary = "test edges around a flip, or all in sweeps",
                                     .standard = "stack",
                                     .choices = [] {
                                       return std::vector<std::string_view>{"stack", "sweeps"};
                                     }};
constexpr Parameter scan_parameter{
    .name = "scan",
    .summary = "the order of a sweep: edges by their ends",
    .standard = "ascending",
    .choices = [] {
      return std::vector<std::string_view>{"ascending", "descending", "shuffled"};
    }};
constexpr Parameter flip_seed_parameter{.name = "flip-seed",
                                        .summary = "of random flips and shuffled sweeps",
                                        .standard = "1",
                                        .least = 0,
                                        .most = 0xFFFFFFFF};

inline constexpr std::array flip_parameters{start_parameter, random_flips_parameter, method_parameter,
                                            scan_parameter, flip_seed_parameter};

/// From settings that were accepted for these.
inline FlipOptions flip_options(const Settings& settings) {
  return {.start = choice_as<Start>(settings, start_parameter),
          .random_flips = whole_number(settings, random_flips_parameter),
          .method = choice_as<Method>(settings, method_parameter),
          .scan = choice_as<Scan>(settings, scan_parameter),
          .seed = whole_number(settings, flip_seed_parameter)};
}

}  // namespace tribunal
