// A sign together with the stage of the backend that settled it.
#pragma once

#include "predicates/sign.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace tribunal {

/// Where a backend's answer came from, cheapest first.
enum class Stage : std::uint8_t {
  rounded,        ///< floating point, nothing certified: the sign may be wrong
  filter,         ///< floating point with a certified error bound
  double_double,  ///< pairs of doubles with a certified error bound
  integer,        ///< integers of a fixed width that holds every intermediate value
  expansion,      ///< sums of doubles that do not overlap, as long as it takes
  exact,          ///< arithmetic of unbounded precision
  symbolic,       ///< a tie, broken by the order of the points
  plugin,         ///< an outsider's code, which does not say
};

inline constexpr std::array<std::string_view, 8> stage_names{
    "rounded", "filter", "double-double", "integer", "expansion", "exact", "symbolic", "plugin"};
constexpr std::string_view to_string(Stage s) { return stage_names[static_cast<std::size_t>(s)]; }

struct Decision {
  Sign sign;
  Stage stage;
};

}  // namespace tribunal
