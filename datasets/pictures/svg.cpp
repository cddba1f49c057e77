#include "datasets/pictures/drawing.hpp"

#include <charconv>

namespace tribunal::pictures {
namespace {

void append(std::string& text, double value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 2).ptr);
}

void append(std::string& text, char command, const Position& p) {
  text += command;
  append(text, p.x);
  text += ' ';
  append(text, p.y);
}

void append(std::string& text, Colour colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  text += '#';
  for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) {
    text += digits[part >> 4U];
    text += digits[part & 15U];
  }
}

/// Renderers blend each polygon's border with what lies beneath; a hair of its own colour closes the seams.
void append(std::string& text, const Areas& areas) {
  text += "<path stroke-linejoin=\"round\" stroke-width=\".4\" fill=\"";
  append(text, areas.fill);
  text += "\" stroke=\"";
  append(text, areas.fill);
  text += "\" d=\"";
  for (const Polygon& polygon : areas.polygons) {
    char command = 'M';
    for (const Position& p : polygon) {
      append(text, command, p);
      command = 'L';
    }
    text += "Z\n";
  }
  text += "\"/>\n";
}

void append(std::string& text, const Lines& lines) {
  text += "<path fill=\"none\" stroke-linecap=\"round\" stroke=\"";
  append(text, lines.colour);
  text += "\" stroke-width=\"";
  append(text, lines.width);
  text += "\" d=\"";
  for (const auto& [from, to] : lines.strokes) {
    append(text, 'M', from);
    append(text, 'L', to);
    text += '\n';
  }
  text += "\"/>\n";
}

}  // namespace

std::string svg(const Drawing& drawing) {
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  append(text, drawing.width);
  text += ' ';
  append(text, drawing.height);
  text += "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (const Areas& areas : drawing.areas)
    if (!areas.polygons.empty()) append(text, areas);
  for (const Lines& lines : drawing.lines)
    if (!lines.strokes.empty()) append(text, lines);
  return text + "</svg>\n";
}

}  // namespace tribunal::pictures
