// Domain checks that backends share: which points may be bound.
#pragma once

#include "predicates/kernel.hpp"
#include "predicates/point.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace tribunal {

template <int D>
bool is_finite(const Point<D>& p) {
  for (const double c : p.coordinate)
    if (!std::isfinite(c)) return false;
  return true;
}

/// The first point with a NaN or infinite coordinate, as a refusal; nothing when all are finite.
template <int D>
std::optional<Refusal> refuse_non_finite(std::span<const Point<D>> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) return Refusal{i, "a coordinate is not finite"};
  return std::nullopt;
}

/// "x = 0.1": a coordinate as refusals name it, in the shortest decimals that read back to the same double.
inline std::string name_coordinate(int axis, double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return std::string(1, "xyz"[axis]) + " = " + std::string(text.data(), end);
}

}  // namespace tribunal
