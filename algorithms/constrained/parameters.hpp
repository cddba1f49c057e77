// The variants of constrained triangulation that users choose among.
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "algorithms/parameter.hpp"

#include <array>
#include <optional>

namespace tribunal::constrained {

inline constexpr std::array parameters{
    Parameter{.name = "recovery",
              .summary = "how a missing segment gets in",
              .standard = "cavity",
              .choices =
                  [] {
                    return std::vector<std::string_view>{"swaps", "cavity"};
                  }},
    Parameter{.name = "crossings",
              .summary = "segments that cross",
              .standard = "refuse",
              .choices =
                  [] {
                    return std::vector<std::string_view>{"refuse", "split"};
                  }},
    Parameter{.name = "domain",
              .summary = "what is meshed; auto: polygons by the even-odd rule, a .poly carved, else the hull",
              .standard = "auto",
              .choices =
                  [] {
                    return std::vector<std::string_view>{"hull", "carved", "even-odd", "auto"};
                  }},
};

/// Values of the parameters. The settings must have been accepted.
inline Recovery recovery(const Settings& settings) { return choice_as<Recovery>(settings, parameters[0]); }
inline bool splits_crossings(const Settings& settings) { return choice_index(settings, parameters[1]) == 1; }
/// Nothing where the input decides.
inline std::optional<Domain> domain(const Settings& settings) {
  const auto chosen = choice_index(settings, parameters[2]);
  return chosen == 3 ? std::nullopt : std::optional(static_cast<Domain>(chosen));
}

}  // namespace tribunal::constrained
