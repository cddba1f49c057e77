// Pixels, and how much of each a convex polygon covers.
#pragma once

#include "datasets/pictures/drawing.hpp"

#include <cstddef>

namespace tribunal::pictures {

/// A white canvas. Coverage is exact along rows, and of `samples` lines in each across them.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height)
      : width_(width), height_(height), pixels_(width * height, paper) {}

  /// Adds a polygon's colour in proportion to coverage, so that polygons side by side leave no seam between
  /// them. Those of one canvas must not overlap.
  void fill(const Polygon& polygon, Colour colour);

  /// Paints a polygon over what is there, with coverage in eighths: fewer colours make smaller files.
  void paint(const Polygon& polygon, Colour colour);

  /// Row by row, three bytes for each pixel.
  std::vector<std::uint8_t> rgb() const;

 private:
  using Pixel = std::array<float, 3>;
  static constexpr Pixel paper{255, 255, 255};
  static constexpr int samples = 16;

  /// visit(pixel, coverage) for each pixel that the polygon touches.
  template <class Visit>
  void cover(const Polygon& polygon, Visit visit);

  /// Adds what the span from `left` to `right` covers of each pixel in its row.
  void add_span(double left, double right);

  std::size_t width_, height_;
  std::vector<Pixel> pixels_;
  std::vector<float> row_ = std::vector<float>(width_, 0.0F);  ///< coverage, zero between rows
};

}  // namespace tribunal::pictures
