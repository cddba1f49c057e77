// What a picture is made of, whatever kind of file it goes to.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tribunal::pictures {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// On the sheet: x to the right, y downwards, from its upper left corner.
struct Position {
  double x = 0, y = 0;
};
using Polygon = std::vector<Position>;
using Stroke = std::array<Position, 2>;

/// Convex polygons of one colour.
struct Areas {
  Colour fill;
  std::vector<Polygon> polygons;
};

/// Straight lines with round ends; one without length is a dot.
struct Lines {
  Colour colour;
  double width = 1;
  std::vector<Stroke> strokes;
};

/// A white sheet, areas that do not overlap, and over them lines, the later over the earlier.
struct Drawing {
  double width = 0, height = 0;
  std::vector<Areas> areas;
  std::vector<Lines> lines;
};

/// As the text of an .svg file.
std::string svg(const Drawing& drawing);

/// As the bytes of a .png file, each unit of the sheet 1.2 pixels wide. O(pixels + covered pixels of all
/// parts). Same drawing, same pixels.
std::string png(const Drawing& drawing);

}  // namespace tribunal::pictures
