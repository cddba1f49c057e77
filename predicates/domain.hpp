// Domain checks that backends share: which points may be bound.
#pragma once

#include "predicates/environment.hpp"
#include "predicates/kernel.hpp"
#include "predicates/point.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tribunal {

template <int D>
bool is_finite(const Point<D>& p) {
  for (const double c : p.coordinate)
    if (!std::isfinite(c)) return false;
  return true;
}

/// An unsound floating-point environment as a refusal of all points, nothing when it is sound: under another
/// rounding mode, or with subnormal numbers flushed, even what is certified may be wrong. Whatever binds asks
/// first; a change after that is not seen.
inline std::optional<Refusal> refuse_environment() {
  std::string fault = describe_fault(witness_floating_point());
  if (fault.empty()) return std::nullopt;
  return Refusal{0, std::move(fault)};
}

/// What no backend accepts, as a refusal: an unsound environment, or the first point with a NaN or infinite
/// coordinate.
template <int D>
std::optional<Refusal> refuse_unusable(std::span<const Point<D>> points) {
  if (auto refusal = refuse_environment()) return refusal;
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
