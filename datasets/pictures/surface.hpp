// A function that is linear in each triangle, as bands and contours.
#pragma once

#include "datasets/pictures/clip.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace tribunal::pictures {

/// Values at points, brought to [0, 1] from the least to the greatest, and cut into bands of equal height by
/// the levels 1/bands, 2/bands and so on. Bringing them there keeps their order, so that a contour enters one
/// triangle where it leaves its neighbour whatever is rounded.
class Bands {
 public:
  /// Values are finite. Where all are equal, all stand at 0.
  Bands(std::span<const double> values, std::size_t bands);

  std::size_t count() const { return bands_; }
  double height(std::size_t point) const { return heights_[point]; }
  double level(std::size_t k) const { return static_cast<double>(k) / static_cast<double>(bands_); }
  double least() const { return least_; }
  double greatest() const { return greatest_; }

  /// The band that a height belongs to; a level belongs to the band above it, 1 to the last one.
  std::size_t band(double height) const;

  /// visit(k, polygon) for the parts of a polygon, its heights at its corners, in the bands it reaches.
  template <class Visit>
  void split(const std::vector<Corner>& polygon, Visit visit) const;

  /// The contours in a triangle: a level runs between corners below it and corners on it or above it.
  std::vector<Stroke> contours(const std::array<Corner, 3>& triangle) const;

 private:
  std::size_t bands_;
  std::vector<double> heights_;
  double least_ = 0, greatest_ = 0;
};

template <class Visit>
void Bands::split(const std::vector<Corner>& polygon, Visit visit) const {
  if (polygon.empty()) return;
  std::size_t low = bands_, high = 0;
  for (const Corner& corner : polygon) {
    low = std::min(low, band(corner.value));
    high = std::max(high, band(corner.value));
  }
  for (std::size_t k = low; k <= high; ++k) {
    std::vector<Corner> part = polygon;
    if (k > low) part = part_where(part, [&](const Corner& c) { return c.value - level(k); });
    if (k < high) part = part_where(part, [&](const Corner& c) { return level(k + 1) - c.value; });
    visit(k, part);
  }
}

}  // namespace tribunal::pictures
