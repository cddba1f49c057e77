// What users may ask of circumcentre refinement.
#pragma once

#include "algorithms/parameter.hpp"
#include "algorithms/refinement/chew.hpp"

#include <array>

namespace tribunal::refinement {

inline constexpr Values angle_values{.describe = "a number of degrees from 0 to 60, 60 excluded",
                                     .holds = [](std::string_view text) {
                                       const auto angle = parse_number(text);
                                       return angle && 0 <= *angle && *angle < 60;
                                     }};
inline constexpr Values ratio_values{.describe = "none, or a number above 0.5774",
                                     .holds = [](std::string_view text) {
                                       const auto ratio = parse_number(text);
                                       return text == "none" || (ratio && *ratio > 0.5774);
                                     }};
inline constexpr Values size_values{
    .describe = "none, boundary, a positive length, or a formula of x and y",
    .holds = [](std::string_view text) { return refusal_of(Size::parse, text).empty(); },
    .reason = [](std::string_view text) { return refusal_of(Size::parse, text); }};

inline constexpr std::array chew_parameters{
    Parameter{.name = "angle",
              .summary = "the smallest angle wanted, in degrees",
              .standard = "30",
              .values = &angle_values},
    Parameter{
        .name = "ratio",
        .summary = "instead of an angle, the largest circumradius over shortest edge: 1 / (2 sin angle)",
        .standard = "none",
        .values = &ratio_values},
    Parameter{.name = "size",
              .summary = "the longest edge allowed; boundary: as long as the segments nearby",
              .standard = "none",
              .values = &size_values},
    Parameter{.name = "vertices",
              .summary = "give up beyond so many",
              .standard = "2000000",
              .least = 3,
              .most = 400'000'000},
};

/// The options that accepted settings mean.
inline ChewOptions chew_options(const Settings& settings) {
  ChewOptions options;
  const std::string ratio = value_of(settings, chew_parameters[1]);
  options.bound = ratio == "none" ? AngleBound::degrees(*parse_number(value_of(settings, chew_parameters[0])))
                                  : AngleBound::radius_to_edge(*parse_number(ratio));
  options.size = Size::parse(value_of(settings, chew_parameters[2]));
  options.most_vertices = whole_number(settings, chew_parameters[3]);
  return options;
}

}  // namespace tribunal::refinement
