// Parts of convex polygons and of lines.
#pragma once

#include "datasets/pictures/drawing.hpp"

namespace tribunal::pictures {

/// A corner with the value there of a function that is linear over its polygon.
struct Corner {
  Position at;
  double value = 0;
};

/// The point between two corners where a linear function has the value 0 that is `here` (not negative) at one
/// and `there` (negative) at the other.
inline Corner crossing(const Corner& a, double here, const Corner& b, double there) {
  const double part = here / (here - there);
  const auto between = [part](double from, double to) { return from + part * (to - from); };
  return {{between(a.at.x, b.at.x), between(a.at.y, b.at.y)}, between(a.value, b.value)};
}

/// The part of a convex polygon where a linear function is not negative, given at corners (Sutherland and
/// Hodgman 1974, one side). Corners that are made where it is zero are given to `settle`.
template <class Function, class Settle = void (*)(Corner&)>
std::vector<Corner> part_where(
    const std::vector<Corner>& polygon, Function function, Settle settle = [](Corner&) {}) {
  std::vector<Corner> part;
  const auto cut = [&](const Corner& a, double here, const Corner& b, double there) {
    part.push_back(crossing(a, here, b, there));
    settle(part.back());
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double here = function(a), there = function(b);
    if (here >= 0) part.push_back(a);
    if (here >= 0 && there < 0) cut(a, here, b, there);
    if (here < 0 && there >= 0) cut(b, there, a, here);
  }
  return part;
}

/// A side of a sheet: on it a coordinate is `at`, and on the sheet not less (or more, with sign -1).
struct Border {
  double Position::*coordinate;
  double at, sign;

  double inside(const Position& p) const { return sign * (p.*coordinate - at); }
  /// What was cut here lies here, exactly: rounded, a cut far outside the sheet's corners may miss all of it.
  void snap(Position& p) const { p.*coordinate = at; }
};
inline std::array<Border, 4> borders(double width, double height) {
  return {
      {{&Position::x, 0, 1}, {&Position::y, 0, 1}, {&Position::x, width, -1}, {&Position::y, height, -1}}};
}

/// The part of a polygon on a sheet of this size.
inline std::vector<Corner> part_within(std::vector<Corner> polygon, double width, double height) {
  for (const Border& border : borders(width, height))
    polygon = part_where(
        polygon, [&](const Corner& c) { return border.inside(c.at); }, [&](Corner& c) { border.snap(c.at); });
  return polygon;
}

/// The same of a line; false where nothing of it is there.
inline bool clip(Stroke& stroke, double width, double height) {
  for (const Border& border : borders(width, height))
    for (const auto [here, there] : {std::array{0, 1}, std::array{1, 0}}) {
      const double a = border.inside(stroke[here]), b = border.inside(stroke[there]);
      if (b >= 0) continue;
      if (a < 0) return false;
      stroke[there] = crossing({stroke[here]}, a, {stroke[there]}, b).at;
      border.snap(stroke[there]);
    }
  return true;
}

}  // namespace tribunal::pictures
