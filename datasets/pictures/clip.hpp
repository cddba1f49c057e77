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
/// Hodgman 1974, one side).
template <class Function>
std::vector<Corner> part_where(const std::vector<Corner>& polygon, Function function) {
  std::vector<Corner> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double here = function(a), there = function(b);
    if (here >= 0) part.push_back(a);
    if (here >= 0 && there < 0) part.push_back(crossing(a, here, b, there));
    if (here < 0 && there >= 0) part.push_back(crossing(b, there, a, here));
  }
  return part;
}

/// The part of a polygon on a sheet of this size.
inline std::vector<Corner> part_within(std::vector<Corner> polygon, double width, double height) {
  polygon = part_where(polygon, [](const Corner& c) { return c.at.x; });
  polygon = part_where(polygon, [](const Corner& c) { return c.at.y; });
  polygon = part_where(polygon, [=](const Corner& c) { return width - c.at.x; });
  return part_where(polygon, [=](const Corner& c) { return height - c.at.y; });
}

/// The same of a line; false where nothing of it is there.
inline bool clip(Stroke& stroke, double width, double height) {
  const auto side = [&](auto inside) {
    for (const auto [here, there] : {std::array{0, 1}, std::array{1, 0}}) {
      const double a = inside(stroke[here]), b = inside(stroke[there]);
      if (b >= 0) continue;
      if (a < 0) return false;
      stroke[there] = crossing({stroke[here]}, a, {stroke[there]}, b).at;
    }
    return true;
  };
  return side([](const Position& p) { return p.x; }) && side([](const Position& p) { return p.y; }) &&
         side([=](const Position& p) { return width - p.x; }) &&
         side([=](const Position& p) { return height - p.y; });
}

}  // namespace tribunal::pictures
