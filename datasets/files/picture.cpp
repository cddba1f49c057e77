#include "datasets/files/picture.hpp"

#include "datasets/files/files.hpp"
#include "datasets/files/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace tribunal {
namespace {

constexpr double width = 1000, margin = 10;

struct Box {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

Box box_of(std::span<const Point2> points) {
  Box box;
  for (const Point2& p : points)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  return box;
}

/// From the plane to the sheet. Coordinates are first scaled by a power of two to at most 1 in size, exactly,
/// so that no finite box overflows or vanishes.
class Sheet {
 public:
  explicit Sheet(const Box& box) {
    double largest = 0;
    for (const Point2& corner : {box.low, box.high})
      for (const double c : corner.coordinate) largest = std::max(largest, std::fabs(c));
    exponent_ = largest > 0 ? -std::ilogb(largest) - 1 : 0;
    low_ = {scaled(box.low[0]), scaled(box.low[1])};
    const double w = scaled(box.high[0]) - low_[0], h = scaled(box.high[1]) - low_[1];
    const double longer = std::max(w, h);
    scale_ = longer > 0 ? (width - 2 * margin) / longer : 0;
    height_ = h * scale_ + 2 * margin;
    width_ = w * scale_ + 2 * margin;
  }
  double x(const Point2& p) const { return margin + (scaled(p[0]) - low_[0]) * scale_; }
  double y(const Point2& p) const { return height_ - margin - (scaled(p[1]) - low_[1]) * scale_; }
  double sheet_width() const { return width_; }
  double sheet_height() const { return height_; }

 private:
  double scaled(double c) const { return std::ldexp(c, exponent_); }

  int exponent_ = 0;
  Point2 low_{};
  double scale_ = 0, width_ = 0, height_ = 0;
};

void append(std::string& text, double value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 2).ptr);
}

void append_position(std::string& text, const Sheet& sheet, const Point2& p) {
  append(text, sheet.x(p));
  text += ' ';
  append(text, sheet.y(p));
}

void append_strokes(std::string& svg, const Sheet& sheet, std::span<const Point2> points,
                    std::span<const std::array<std::uint32_t, 2>> strokes, double line) {
  if (strokes.empty()) return;
  svg += "<path fill=\"none\" stroke=\"#b3261e\" stroke-linecap=\"round\" stroke-width=\"";
  append(svg, line);
  svg += "\" d=\"";
  for (const auto& [a, b] : strokes) {
    svg += 'M';
    append_position(svg, sheet, points[a]);
    svg += 'L';
    append_position(svg, sheet, points[b]);
    svg += '\n';
  }
  svg += "\"/>\n";
}

}  // namespace

void require_picture_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".svg" && ending != ".SVG")
    throw BadInput(path.string() + ": pictures are written as .svg, not '" + ending + "'");
}

void write_picture(const std::filesystem::path& path, std::span<const Point2> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::span<const std::array<std::uint32_t, 2>> strokes) {
  require_picture_ending(path);
  const Sheet sheet(box_of(points));
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  append(svg, sheet.sheet_width());
  svg += ' ';
  append(svg, sheet.sheet_height());
  svg += "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  // Thinner lines for denser meshes: a fixed share of the mean edge length, between a hair and a pencil.
  const double spacing = width / std::max(1.0, std::sqrt(static_cast<double>(points.size())));
  svg += "<path fill=\"#eef3f8\" stroke=\"#1f4e79\" stroke-linejoin=\"round\" stroke-width=\"";
  const double line = std::clamp(spacing * 0.04, 0.05, 1.5);
  append(svg, line);
  svg += "\" d=\"";
  for (const auto& t : triangles) {
    svg += 'M';
    append_position(svg, sheet, points[t[0]]);
    for (std::size_t k = 1; k < 3; ++k) {
      svg += 'L';
      append_position(svg, sheet, points[t[k]]);
    }
    svg += "Z\n";
  }
  svg += "\"/>\n";
  if (triangles.empty()) {
    svg += "<g fill=\"#1f4e79\">\n";
    for (const Point2& p : points) {
      svg += "<circle r=\"3\" cx=\"";
      append(svg, sheet.x(p));
      svg += "\" cy=\"";
      append(svg, sheet.y(p));
      svg += "\"/>\n";
    }
    svg += "</g>\n";
  }
  append_strokes(svg, sheet, points, strokes, 2.5 * line);
  svg += "</svg>\n";
  write_text(path, svg);
}

}  // namespace tribunal
