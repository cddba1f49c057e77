// Domain checks that backends share: which points may be bound.
#pragma once

#include "predicates/kernel.hpp"
#include "predicates/point.hpp"

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

}  // namespace tribunal
