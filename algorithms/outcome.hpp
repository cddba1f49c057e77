// How a computation ended. Failures are data: each is a value in a result row, none ends a campaign.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tribunal {

enum class Outcome : std::uint8_t {
  ok,
  non_delaunay,            ///< finished, but the exact checker finds an edge that is not locally Delaunay
  invalid_topology,        ///< finished, but the checker finds no triangulation of the sites
  missing_site,            ///< finished, but a site is in no triangle
  inconsistent_predicate,  ///< the algorithm met signs that no point set can have
  loop,                    ///< a step budget ran out
  crash,
  timeout,
  out_of_memory,
  out_of_domain,  ///< the backend refused the points
  refused_input,  ///< the algorithm refused the points
};

inline constexpr std::array<std::string_view, 11> outcome_names{
    "ok",    "non_delaunay", "invalid_topology", "missing_site",  "inconsistent_predicate", "loop",
    "crash", "timeout",      "out_of_memory",    "out_of_domain", "refused_input"};

constexpr std::string_view to_string(Outcome outcome) {
  return outcome_names[static_cast<std::size_t>(outcome)];
}

constexpr std::optional<Outcome> parse_outcome(std::string_view name) {
  for (std::size_t i = 0; i < outcome_names.size(); ++i)
    if (outcome_names[i] == name) return static_cast<Outcome>(i);
  return std::nullopt;
}

}  // namespace tribunal
