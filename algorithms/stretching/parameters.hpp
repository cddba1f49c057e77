// What users choose about stretched refinement.
#pragma once

#include "algorithms/parameter.hpp"
#include "algorithms/stretching/stretched.hpp"

#include <array>

namespace tribunal::stretching {

inline constexpr Values positive{.describe = "a number above 0", .holds = [](std::string_view text) {
                                   const auto number = parse_number(text);
                                   return number && *number > 0;
                                 }};
inline constexpr Values growth{.describe = "a number from 1 on", .holds = [](std::string_view text) {
                                 const auto number = parse_number(text);
                                 return number && *number >= 1;
                               }};

inline constexpr std::array parameters{
    Parameter{.name = "wall", .summary = "spacing at the walls", .standard = "1e-4", .values = &positive},
    Parameter{.name = "growth", .summary = "of each layer to the next", .standard = "1.3", .values = &growth},
    Parameter{.name = "most", .summary = "the largest spacing", .standard = "1e300", .values = &positive},
    Parameter{
        .name = "walls",
        .summary = "inner: segments that do not hang together with the outer boundary, if there are any",
        .standard = "inner",
        .choices =
            [] {
              return std::vector<std::string_view>{"inner", "all"};
            }},
    Parameter{.name = "vertices",
              .summary = "give up beyond so many",
              .standard = "10000000",
              .least = 3,
              .most = 500'000'000},
};

/// From settings that were accepted for these.
inline Options options_of(const Settings& settings) {
  const auto number = [&](const Parameter& parameter) {
    return *parse_number(value_of(settings, parameter));
  };
  return {.spacing = {number(parameters[0]), number(parameters[1]), number(parameters[2])},
          .walls = choice_as<WallChoice>(settings, parameters[3]),
          .most_vertices = whole_number(settings, parameters[4])};
}

}  // namespace tribunal::stretching
