// The names of the predicates that every kernel answers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tribunal {

enum class Predicate : std::uint8_t { orient2d, incircle, orient3d, insphere };

inline constexpr std::array<Predicate, 4> all_predicates{Predicate::orient2d, Predicate::incircle,
                                                         Predicate::orient3d, Predicate::insphere};
inline constexpr std::array<std::string_view, 4> predicate_names{"orient2d", "incircle", "orient3d",
                                                                 "insphere"};
constexpr std::string_view to_string(Predicate p) { return predicate_names[static_cast<std::size_t>(p)]; }

/// Of the points it asks about: 2 or 3.
constexpr int dimension_of(Predicate p) {
  return p == Predicate::orient2d || p == Predicate::incircle ? 2 : 3;
}

/// How many points it asks about: D + 1 for an orientation, D + 2 for a position relative to a sphere.
constexpr int points_of(Predicate p) {
  return dimension_of(p) + (p == Predicate::orient2d || p == Predicate::orient3d ? 1 : 2);
}

/// What a planar kernel answers besides: questions about sizes, not positions. No plug-in offers them.
enum class Comparison : std::uint8_t { length, angle };

inline constexpr std::array<std::string_view, 2> comparison_names{"compare_length", "compare_angle"};

}  // namespace tribunal
