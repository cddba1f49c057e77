#include "datasets/pictures/canvas.hpp"
#include "datasets/pictures/drawing.hpp"

#include <png.h>

#include <cmath>
#include <stdexcept>

namespace tribunal::pictures {
namespace {

constexpr double pixels_per_unit = 1.2;

Position in_pixels(const Position& p) { return {p.x * pixels_per_unit, p.y * pixels_per_unit}; }

Polygon in_pixels(Polygon polygon) {
  for (Position& p : polygon) p = in_pixels(p);
  return polygon;
}

/// The stroke as an area: its ends are square here, which at these widths nobody sees.
Polygon outline(const Stroke& stroke, double width) {
  const Position a = in_pixels(stroke[0]), b = in_pixels(stroke[1]);
  const double length = std::hypot(b.x - a.x, b.y - a.y), half = width * pixels_per_unit / 2;
  const double x = length > 0 ? (b.x - a.x) / length * half : half;
  const double y = length > 0 ? (b.y - a.y) / length * half : 0;
  return {{a.x - x + y, a.y - y - x},
          {b.x + x + y, b.y + y - x},
          {b.x + x - y, b.y + y + x},
          {a.x - x - y, a.y - y + x}};
}

std::string encode(const Canvas& canvas, std::size_t width, std::size_t height) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  const std::vector<std::uint8_t> pixels = canvas.rgb();
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string png(const Drawing& drawing) {
  const auto width = static_cast<std::size_t>(std::ceil(drawing.width * pixels_per_unit));
  const auto height = static_cast<std::size_t>(std::ceil(drawing.height * pixels_per_unit));
  Canvas canvas(width, height);
  for (const Areas& areas : drawing.areas)
    for (const Polygon& polygon : areas.polygons) canvas.fill(in_pixels(polygon), areas.fill);
  for (const Lines& lines : drawing.lines)
    for (const Stroke& stroke : lines.strokes) canvas.paint(outline(stroke, lines.width), lines.colour);
  return encode(canvas, width, height);
}

}  // namespace tribunal::pictures
