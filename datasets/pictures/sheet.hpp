// From the plane to the sheet.
#pragma once

#include "datasets/pictures/drawing.hpp"
#include "predicates/point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace tribunal::pictures {

struct Box {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

inline Box box_of(std::span<const Point2> points) {
  Box box;
  for (const Point2& p : points)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  return box;
}

/// The longer side of the box becomes 1000 units with its margins. Coordinates are first scaled by a power of
/// two to at most 1 in size, exactly, so that no finite box overflows or vanishes.
class Sheet {
 public:
  static constexpr double longest = 1000, margin = 10;

  explicit Sheet(const Box& box) {
    double largest = 0;
    for (const Point2& corner : {box.low, box.high})
      for (const double c : corner.coordinate) largest = std::max(largest, std::fabs(c));
    exponent_ = largest > 0 ? -std::ilogb(largest) - 1 : 0;
    low_ = {scaled(box.low[0]), scaled(box.low[1])};
    const double w = scaled(box.high[0]) - low_[0], h = scaled(box.high[1]) - low_[1];
    scale_ = std::max(w, h) > 0 ? (longest - 2 * margin) / std::max(w, h) : 0;
    width_ = w * scale_ + 2 * margin;
    height_ = h * scale_ + 2 * margin;
  }
  /// What is more than 1e100 units away from a window counts as so far away.
  Position at(const Point2& p) const {
    const auto units = [&](std::size_t axis) {
      return std::clamp((scaled(p[axis]) - low_[axis]) * scale_, -1e100, 1e100);
    };
    return {margin + units(0), height_ - margin - units(1)};
  }
  double width() const { return width_; }
  double height() const { return height_; }

 private:
  double scaled(double c) const { return std::ldexp(c, exponent_); }

  int exponent_ = 0;
  Point2 low_{};
  double scale_ = 0, width_ = 0, height_ = 0;
};

}  // namespace tribunal::pictures
