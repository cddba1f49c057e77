// Laws of clipping, coverage and colours.
#include "datasets/pictures/canvas.hpp"

#include "datasets/pictures/clip.hpp"
#include "datasets/pictures/numerals.hpp"
#include "datasets/pictures/palette.hpp"
#include "datasets/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tribunal::pictures {
namespace {

double area(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    doubled += a.x * b.y - b.x * a.y;
  }
  return std::fabs(doubled) / 2;
}

constexpr Colour black{0, 0, 0};

/// What is dark on a canvas, in pixels.
double darkness(const Canvas& canvas) {
  double sum = 0;
  for (const std::uint8_t part : canvas.rgb()) sum += (255 - part) / 255.0 / 3;
  return sum;
}

TEST(Canvas, DarkensByTheAreaOfAPolygon) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    Polygon triangle;
    for (int k = 0; k < 3; ++k) {
      const double x = 60 * random.unit(), y = 40 * random.unit();
      triangle.push_back({x, y});
    }
    Canvas canvas(60, 40);
    canvas.fill(triangle, black);
    EXPECT_NEAR(darkness(canvas), area(triangle), 1.5) << i;
  }
}

TEST(Canvas, PolygonsSideBySideLeaveNoSeam) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const double x = 5 + 20 * random.unit(), y = 5 + 20 * random.unit();
    const Position middle{x, y};
    const Polygon corners{{0, 0}, {30, 0}, {30, 30}, {0, 30}};
    Canvas canvas(30, 30);
    for (std::size_t k = 0; k < 4; ++k) canvas.fill({corners[k], corners[(k + 1) % 4], middle}, {10, 20, 30});
    const auto bytes = canvas.rgb();
    for (std::size_t byte = 0; byte < bytes.size(); ++byte)
      ASSERT_EQ(bytes[byte], 10 * (1 + byte % 3)) << "pixel " << byte / 3;
  }
}

TEST(Canvas, WhatLiesOutsideIsLeftOut) {
  Canvas canvas(10, 10);
  canvas.paint({{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}, black);
  EXPECT_NEAR(darkness(canvas), 100, 1e-9);
  Canvas empty(10, 10);
  empty.paint({{-5, 3}, {-1, 3}, {-1, 8}}, black);
  empty.paint({{3, 12}, {8, 12}, {8, 15}}, black);
  EXPECT_EQ(darkness(empty), 0);
}

TEST(Clip, ATriangleAroundTheSheetLeavesTheSheet) {
  const std::vector<Corner> around{{{-1000, -50}}, {{1000, -50}}, {{0, 1000}}};
  Polygon polygon;
  for (const Corner& corner : part_within(around, 20, 30)) polygon.push_back(corner.at);
  EXPECT_NEAR(area(polygon), 600, 1e-9);
  EXPECT_TRUE(part_within({{{-3, 0}}, {{-1, 0}}, {{-1, 9}}}, 20, 30).empty());
}

/// A line's part on the sheet, against many points of the line looked at one by one.
/// The corners of a triangle around it may be so far away that a cut misses a side by more than its length.
TEST(Clip, ATriangleFarAroundTheSheetLeavesTheSheet) {
  for (const double far : {1e3, 1e15, 1e19, 1e100}) {
    const std::vector<Corner> part =
        part_within({{{-far, -0.7 * far}}, {{1.3 * far, -far}}, {{0.3 * far, far}}}, 100, 60);
    double twice = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Position a = part[i].at, b = part[(i + 1) % part.size()].at;
      twice += a.x * b.y - a.y * b.x;
    }
    EXPECT_DOUBLE_EQ(std::fabs(twice) / 2, 6000) << far;
  }
}

TEST(Clip, ALineKeepsItsPointsOnTheSheet) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    Stroke whole;
    for (Position& end : whole) {
      end.x = 60 * random.unit() - 20;
      end.y = 60 * random.unit() - 20;
    }
    Stroke part = whole;
    const bool some = clip(part, 20, 20);
    for (int k = 0; k <= 100; ++k) {
      const double x = std::lerp(whole[0].x, whole[1].x, k / 100.0);
      const double y = std::lerp(whole[0].y, whole[1].y, k / 100.0);
      const bool inside = x > 1e-9 && y > 1e-9 && x < 20 - 1e-9 && y < 20 - 1e-9;
      if (!inside) continue;
      ASSERT_TRUE(some);
      const double along = (x - part[0].x) * (part[1].x - x) + (y - part[0].y) * (part[1].y - y);
      ASSERT_GE(along, -1e-9) << "a point of the line was cut off";
    }
    if (!some) continue;
    for (const Position& end : part)
      ASSERT_TRUE(end.x >= -1e-9 && end.y >= -1e-9 && end.x <= 20 + 1e-9 && end.y <= 20 + 1e-9);
  }
}

double luminance(Colour c) {
  const auto light = [](std::uint8_t part) { return std::pow(part / 255.0, 2.2); };
  return 0.2126 * light(c.red) + 0.7152 * light(c.green) + 0.0722 * light(c.blue);
}

TEST(Palette, DarkensFromEndToEnd) {
  for (int k = 0; k < 32; ++k) EXPECT_GT(luminance(shade(k / 32.0)), luminance(shade((k + 1) / 32.0))) << k;
}

TEST(Numerals, EveryCharacterOfANumberHasStrokes) {
  for (const char c : std::string_view("0123456789.-+e")) {
    const auto strokes = numeral(std::string(1, c), {0, 6}, 6);
    EXPECT_FALSE(strokes.empty()) << c;
    for (const Stroke& stroke : strokes)
      for (const Position& p : stroke) EXPECT_TRUE(p.x >= 0 && p.x <= 4 && p.y >= 0 && p.y <= 6) << c;
  }
}

}  // namespace
}  // namespace tribunal::pictures
