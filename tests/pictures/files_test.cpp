// Laws of the files: a picture's pixels and paths are where the mesh is.
#include "datasets/files/files.hpp"

#include "datasets/pictures/mesh_drawing.hpp"
#include "datasets/pictures/palette.hpp"
#include "datasets/pictures/picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tribunal::pictures {
namespace {

/// A square with its two diagonals: the lower triangle flat, the upper ones with value 1 at the top corners.
struct Envelope {
  std::vector<Point2> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}};
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  std::vector<double> values{0, 0, 1, 1, 0};

  Drawing draw(const PictureStyle& style = {}) const {
    return pictures::draw({points, triangles, {}}, style);
  }
};

struct Pixels {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
  Colour at(double x, double y) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

Pixels decode(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Pixels pixels;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return pixels;
  image.format = PNG_FORMAT_RGB;
  pixels.width = image.width;
  pixels.height = image.height;
  pixels.rgb.resize(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr);
  return pixels;
}

TEST(Png, ColoursAreWhereTheTrianglesAre) {
  const Envelope envelope;
  const Pixels pixels = decode(png(envelope.draw({.colouring = Colouring::field, .field = envelope.values})));
  ASSERT_GE(pixels.width, 1200U);
  EXPECT_EQ(pixels.height, 1200U);
  EXPECT_EQ(pixels.at(600, 1000), shade(0)) << "the flat triangle, at the bottom";
  EXPECT_EQ(pixels.at(600, 20), shade(1)) << "the top";
  EXPECT_EQ(pixels.at(2, 2), (Colour{255, 255, 255})) << "the margin";
}

TEST(Png, AWindowShowsItsPartAlone) {
  const Envelope envelope;
  const PictureStyle style{.colouring = Colouring::field,
                           .field = envelope.values,
                           .window = std::array{Point2{1.5, 0.25}, Point2{2.5, 0.75}}};
  const Pixels pixels = decode(png(envelope.draw(style)));
  for (const double x : {1.0, 300.0, 600.0, 1190.0})
    for (const double y : {1.0, 300.0, 610.0}) EXPECT_EQ(pixels.at(x, y), shade(0)) << x << " " << y;
}

TEST(Drawing, EachEdgeIsDrawnOnce) {
  const Drawing drawing = Envelope().draw();
  std::size_t strokes = 0;
  for (const Lines& lines : drawing.lines) strokes += lines.strokes.size();
  EXPECT_EQ(strokes, 8U);
}

TEST(Drawing, AnglesChooseColours) {
  // Largest angles of 90 and 120 degrees, smallest of 45 and 30.
  const std::vector<Point2> points{{0, 0}, {2, 0}, {1, 1}, {1, -1 / std::sqrt(3.0)}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  const auto filled = [&](Colouring colouring) {
    const Drawing drawing = draw({points, triangles, {}}, {.colouring = colouring});
    std::set<std::size_t> bands;
    for (std::size_t k = 0; k < drawing.areas.size(); ++k)
      if (drawing.areas[k].polygons.size() > 1) bands.insert(k);  // one is the legend's
    return bands;
  };
  const auto largest = filled(Colouring::largest_angle), smallest = filled(Colouring::smallest_angle);
  EXPECT_EQ(largest.size(), 2U);
  EXPECT_TRUE(*largest.begin() == 2 || *largest.begin() == 3) << "90 degrees are a border of bands";
  EXPECT_TRUE(*largest.rbegin() == 5 || *largest.rbegin() == 6);
  EXPECT_EQ(smallest.size(), 2U);
  EXPECT_TRUE(*smallest.begin() == 2 || *smallest.begin() == 3);
}

TEST(Drawing, OfHostileMeshesIsFinite) {
  constexpr double huge = 1.7e308, tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<std::vector<Point2>> meshes{{{-huge, -huge}, {huge, -huge}, {0, huge}},
                                                {{0, 0}, {tiny, 0}, {0, tiny}},
                                                {{0, 0}, {1, 0}, {1e300, 1e-300}}};
  for (const auto& points : meshes)
    for (const Colouring colouring : {Colouring::plain, Colouring::largest_angle, Colouring::smallest_angle})
      for (const bool windowed : {false, true}) {
        PictureStyle style{.colouring = colouring};
        if (windowed) style.window = std::array{Point2{-tiny, -tiny}, Point2{tiny, tiny}};
        const std::vector<std::array<std::uint32_t, 3>> triangle{{0, 1, 2}};
        const Drawing drawing = draw({points, triangle, {}}, style);
        for (const Areas& areas : drawing.areas)
          for (const Polygon& polygon : areas.polygons)
            for (const Position& p : polygon) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
        for (const Lines& lines : drawing.lines)
          for (const Stroke& stroke : lines.strokes)
            for (const Position& p : stroke) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
        EXPECT_GT(png(drawing).size(), 100U);
      }
}

TEST(Picture, EndingsAreKnownOrRefused) {
  EXPECT_NO_THROW(require_picture_ending("a.svg"));
  EXPECT_NO_THROW(require_picture_ending("a.PNG"));
  EXPECT_THROW(require_picture_ending("a.gif"), BadInput);
  EXPECT_THROW(require_picture_ending("a"), BadInput);
}

}  // namespace
}  // namespace tribunal::pictures
