#include "datasets/pictures/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribunal::pictures {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return !(low < high); }
};

/// Where the line at height y meets a convex polygon.
Range section(const Polygon& polygon, double y) {
  Range range;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= y) != (b.y <= y)) range.include(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  return range;
}

std::array<float, 3> channels(Colour colour) {
  return {static_cast<float>(colour.red), static_cast<float>(colour.green), static_cast<float>(colour.blue)};
}

}  // namespace

void Canvas::add_span(double left, double right) {
  left = std::max(left, 0.0);
  right = std::min(right, static_cast<double>(width_));
  for (auto x = static_cast<std::size_t>(left); left < right; ++x) {
    const double border = std::min(right, static_cast<double>(x + 1));
    row_[x] += static_cast<float>((border - left) / samples);
    left = border;
  }
}

template <class Visit>
void Canvas::cover(const Polygon& polygon, Visit visit) {
  Range across, down;
  for (const Position& p : polygon) {
    across.include(p.x);
    down.include(p.y);
  }
  const auto pixel = [](double at, std::size_t most) {
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(most)));
  };
  const std::size_t first = pixel(std::floor(across.low), width_),
                    last = pixel(std::ceil(across.high), width_);
  for (std::size_t y = pixel(std::floor(down.low), height_); y < pixel(std::ceil(down.high), height_); ++y) {
    for (int k = 0; k < samples; ++k) {
      const Range span = section(polygon, static_cast<double>(y) + (k + 0.5) / samples);
      if (!span.is_empty()) add_span(span.low, span.high);
    }
    for (std::size_t x = first; x < last; ++x) {
      if (row_[x] > 0) visit(pixels_[y * width_ + x], row_[x]);
      row_[x] = 0;
    }
  }
}

void Canvas::fill(const Polygon& polygon, Colour colour) {
  const auto ink = channels(colour);
  cover(polygon, [&](Pixel& pixel, float coverage) {
    for (std::size_t c = 0; c < 3; ++c) pixel[c] += coverage * (ink[c] - paper[c]);
  });
}

void Canvas::paint(const Polygon& polygon, Colour colour) {
  const auto ink = channels(colour);
  cover(polygon, [&](Pixel& pixel, float coverage) {
    coverage = std::round(8 * coverage) / 8;
    for (std::size_t c = 0; c < 3; ++c) pixel[c] += coverage * (ink[c] - pixel[c]);
  });
}

std::vector<std::uint8_t> Canvas::rgb() const {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * pixels_.size());
  for (const Pixel& pixel : pixels_)
    for (const float part : pixel)
      bytes.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0F, 255.0F))));
  return bytes;
}

}  // namespace tribunal::pictures
