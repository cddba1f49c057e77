// Laws of bands and contours.
#include "datasets/pictures/surface.hpp"

#include "datasets/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

namespace tribunal::pictures {
namespace {

/// A grid of side x side squares, each cut into two triangles, with a value at every point.
struct Terrain {
  std::size_t side;
  std::vector<double> values;

  explicit Terrain(std::size_t side_of_grid) : side(side_of_grid) {}
  std::size_t point(std::size_t i, std::size_t j) const { return i * (side + 1) + j; }

  template <class Visit>
  void each_triangle(const Bands& bands, Visit visit) const {
    const auto corner = [&](std::size_t i, std::size_t j) -> Corner {
      return {{static_cast<double>(i), static_cast<double>(j)}, bands.height(point(i, j))};
    };
    for (std::size_t i = 0; i < side; ++i)
      for (std::size_t j = 0; j < side; ++j) {
        visit(std::array{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
        visit(std::array{corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
  }
};

double signed_area(const std::vector<Corner>& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position &a = polygon[i].at, &b = polygon[(i + 1) % polygon.size()].at;
    doubled += a.x * b.y - b.x * a.y;
  }
  return doubled / 2;
}

/// Integers: every value is a level, the hardest case, when there are as many bands as steps.
Terrain stepped(std::uint64_t seed, std::uint64_t steps) {
  Terrain terrain(8);
  Random random(seed);
  for (std::size_t i = 0; i < 81; ++i) terrain.values.push_back(static_cast<double>(random.below(steps + 1)));
  return terrain;
}

/// Inside, a contour that enters a triangle has left its neighbour at the very same place, bit for bit.
TEST(Contours, EndAtTheBorderOnly) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Terrain terrain = stepped(seed, 4);
    for (const std::size_t count : {std::size_t{4}, std::size_t{7}}) {
      const Bands bands(terrain.values, count);
      std::map<std::pair<double, double>, int> ends;
      terrain.each_triangle(bands, [&](const std::array<Corner, 3>& triangle) {
        for (const Stroke& stroke : bands.contours(triangle))
          for (const Position& p : stroke) ++ends[{p.x, p.y}];
      });
      EXPECT_FALSE(ends.empty());
      for (const auto& [p, times] : ends) {
        const bool at_border = p.first == 0 || p.second == 0 || p.first == 8 || p.second == 8;
        EXPECT_TRUE(at_border || times % 2 == 0) << p.first << " " << p.second << " seed " << seed;
      }
    }
  }
}

TEST(Contours, OfAPlaneLieOnItsLines) {
  Terrain terrain(8);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) terrain.values.push_back(i + 2 * j);
  const Bands bands(terrain.values, 10);
  double length = 0;
  terrain.each_triangle(bands, [&](const std::array<Corner, 3>& triangle) {
    for (const Stroke& stroke : bands.contours(triangle)) {
      for (const Position& p : stroke) {
        const double level = (p.x + 2 * p.y) / 24 * 10;
        EXPECT_NEAR(level, std::round(level), 1e-12);
      }
      length += std::hypot(stroke[1].x - stroke[0].x, stroke[1].y - stroke[0].y);
    }
  });
  // x + 2y = 2.4 k runs over min(2.4 k, 8) of the square's width, less what lies above it.
  double expected = 0;
  for (int k = 1; k < 10; ++k)
    expected += std::sqrt(1.25) * (std::min(2.4 * k, 8.0) - std::max(2.4 * k - 16, 0.0));
  EXPECT_NEAR(length, expected, 1e-9);
}

TEST(Bands, CutATriangleIntoPartsOfTheirHeights) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Terrain terrain = stepped(seed, 6);
    const Bands bands(terrain.values, 6);
    terrain.each_triangle(bands, [&](const std::array<Corner, 3>& triangle) {
      double sum = 0;
      bands.split({triangle.begin(), triangle.end()}, [&](std::size_t k, const std::vector<Corner>& part) {
        ASSERT_LT(k, bands.count());
        const double size = signed_area(part);
        EXPECT_GE(size, -1e-12);
        sum += size;
        for (const Corner& corner : part) {
          EXPECT_GE(corner.value, bands.level(k) - 1e-12);
          EXPECT_LE(corner.value, bands.level(k + 1) + 1e-12);
        }
      });
      EXPECT_NEAR(sum, 0.5, 1e-12);
    });
  }
}

TEST(Bands, LevelsBelongToTheBandAbove) {
  for (std::size_t count = 1; count <= 100; ++count) {
    const Bands bands(std::vector<double>{0, 1}, count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(bands.band(bands.level(k)), k) << count;
    EXPECT_EQ(bands.band(1), count - 1);
  }
}

TEST(Bands, TakeAnyFiniteValues) {
  const Bands huge(std::vector<double>{-1.7e308, 0, 1.7e308}, 4);
  EXPECT_EQ(huge.height(0), 0);
  EXPECT_NEAR(huge.height(1), 0.5, 1e-15);
  EXPECT_EQ(huge.height(2), 1);
  const Bands tiny(std::vector<double>{0, 5e-324}, 4);
  EXPECT_EQ(tiny.height(1), 1);
  const Bands flat(std::vector<double>{3, 3}, 4);
  EXPECT_EQ(flat.height(0), 0);
  EXPECT_TRUE(flat.contours({Corner{{0, 0}, 0}, Corner{{1, 0}, 0}, Corner{{0, 1}, 0}}).empty());
}

}  // namespace
}  // namespace tribunal::pictures
