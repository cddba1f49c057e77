// What users choose about refinement that follows a solution.
#pragma once

#include "algorithms/refinement/adaptive.hpp"
#include "algorithms/refinement/chew_parameters.hpp"
#include "algorithms/refiners.hpp"

#include <array>
#include <memory>

namespace tribunal::refinement {

inline constexpr Values field_values{
    .describe = "values, shock, slip-line, or a formula of x and y",
    .holds =
        [](std::string_view text) { return text == "values" || refusal_of(formula_field, text).empty(); },
    .reason = [](std::string_view text) { return refusal_of(formula_field, text); }};
inline constexpr Values tolerance_values{.describe = "a number above 0", .holds = [](std::string_view text) {
                                           const auto tolerance = parse_number(text);
                                           return tolerance && *tolerance > 0;
                                         }};

inline constexpr std::array adaptive_parameters{
    chew_parameters[0],
    chew_parameters[1],
    chew_parameters[2],
    chew_parameters[3],
    Parameter{.name = "field",
              .summary = "what is to be resolved; values: the points' third column",
              .standard = "values",
              .values = &field_values},
    Parameter{.name = "tolerance",
              .summary = "of the field's change along an edge, times its length",
              .standard = "0.01",
              .values = &tolerance_values},
};

/// The options that accepted settings mean.
inline AdaptiveOptions adaptive_options(const Settings& settings) {
  Settings chew = settings;
  chew.erase("field");
  chew.erase("tolerance");
  return {chew_options(chew), *parse_number(value_of(settings, adaptive_parameters[5]))};
}

/// The field that they name. Throws Abandon (refused_input) where it is to be the points' and they have none.
inline std::unique_ptr<Field> field_of(const RefinementProblem& problem) {
  const std::string name = value_of(problem.settings, adaptive_parameters[4]);
  if (name != "values") return formula_field(name);
  if (problem.values.empty())
    throw Abandon(
        Outcome::refused_input,
        "adaptive reads a field from the points' third column, and there is none (--set field=...)");
  return linear_field(problem.graph, problem.order, problem.kernel, problem.values);
}

}  // namespace tribunal::refinement
