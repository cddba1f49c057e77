// How large the steps away from the walls shall be.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

namespace tribunal::stretching {

/// The mesh spacing as a function of the distance from the walls (Barth section 3.5): layers whose heights
/// grow geometrically, the first one `wall` high, none higher than `most`. After k layers of heights wall
/// growth^j one is S = wall (growth^k - 1) / (growth - 1) away, and the next is wall + (growth - 1) S high.
struct Spacing {
  double wall, growth, most;

  double at(double distance) const { return std::min(most, wall + (growth - 1) * distance); }

  /// Why it is none; empty where it is one.
  std::string refuse() const {
    if (!(std::isfinite(wall) && wall > 0)) return "the spacing at the wall must be larger than 0";
    if (!(std::isfinite(growth) && growth >= 1)) return "layers must not shrink: their growth is at least 1";
    if (!(std::isfinite(most) && most >= wall))
      return "most, the largest spacing, is less than wall, that at the wall";
    return {};
  }
};

}  // namespace tribunal::stretching
