// Distances from segments and proximity among points, against looking at all of them.
#include "algorithms/stretching/point_tree.hpp"
#include "algorithms/stretching/segment_tree.hpp"
#include "algorithms/stretching/spacing.hpp"
#include "datasets/dataset.hpp"
#include "datasets/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tribunal::stretching {
namespace {

std::vector<Segment> walls_of(const char* dataset, std::uint64_t n) {
  const DatasetGraph graph = find_dataset(dataset)->graph(n, 1);
  std::vector<Segment> segments;
  for (const auto& [a, b] : graph.segments) segments.push_back({graph.points[a], graph.points[b]});
  return segments;
}

Point2 anywhere(Random& random, double half_width) {
  return {{0.5 + half_width * (2 * random.unit() - 1), half_width * (2 * random.unit() - 1)}};
}

TEST(SegmentTree, FindsWhatLookingAtAllSegmentsFinds) {
  for (const char* dataset : {"high-lift", "aerofoil-blunt", "coast"}) {
    const std::vector<Segment> segments = walls_of(dataset, 500);
    const SegmentTree tree(segments);
    Random random(1);
    for (int i = 0; i < 500; ++i) {
      const double width = i % 2 == 0 ? 0.6 : 7;
      const Point2 p = dataset == std::string_view("coast")
                           ? Point2{{8192 * random.unit(), 8192 * random.unit()}}
                           : anywhere(random, width);
      Nearest best{.distance = std::numeric_limits<double>::infinity()};
      for (std::uint32_t s = 0; s < segments.size(); ++s)
        if (const Nearest found = nearest_on(segments[s], p); found.distance < best.distance)
          best = {found.distance, found.direction, s};
      const Nearest found = tree.nearest(p);
      ASSERT_EQ(found.distance, best.distance);
      ASSERT_EQ(found.segment, best.segment);
      ASSERT_EQ(found.direction, best.direction);
    }
  }
}

TEST(SegmentTree, GoingBackAlongTheDirectionLeadsToTheSegments) {
  const std::vector<Segment> segments = walls_of("high-lift", 300);
  const SegmentTree tree(segments);
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Point2 p = anywhere(random, 2);
    const Nearest found = tree.nearest(p);
    EXPECT_NEAR(std::hypot(found.direction[0], found.direction[1]), 1, 1e-15);
    const Point2 foot{
        {p[0] - found.distance * found.direction[0], p[1] - found.distance * found.direction[1]}};
    EXPECT_LE(tree.nearest(foot).distance, 1e-15);
  }
}

TEST(SegmentTree, IsGoodHoweverCloseThePointIs) {
  const Segment wall{Point2{{0, 0}}, Point2{{3, 1}}};
  for (double height = 1; height > 1e-12; height /= 10) {
    const Point2 above{{1.5 - height / std::sqrt(10.0), 0.5 + 3 * height / std::sqrt(10.0)}};
    const Nearest found = nearest_on(wall, above);
    EXPECT_NEAR(found.distance / height, 1, 1e-15 / height);
    EXPECT_NEAR(found.direction[0], -1 / std::sqrt(10.0), 1e-15);
    EXPECT_NEAR(found.direction[1], 3 / std::sqrt(10.0), 1e-15);
  }
  EXPECT_EQ(nearest_on(wall, {{1.5, 0.5}}).distance, 0) << "on the wall";
  EXPECT_EQ(nearest_on(wall, {{-3, -4}}).distance, 5) << "beyond its end";
}

bool any_within_by_looking(const std::vector<Point2>& points, Point2 p, double radius, Point2 except) {
  for (const Point2& q : points) {
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    if (q != except && dx * dx + dy * dy < radius * radius) return true;
  }
  return false;
}

TEST(PointTree, TellsWhatLookingAtAllPointsTells) {
  for (const char* dataset : {"uniform", "clusters", "trailing-edge", "grid", "near-collinear"}) {
    const std::vector<Point2> all = find_dataset(dataset)->generate(600, 6);
    Point2 low = all[0], high = all[0];
    for (const Point2& p : all)
      for (std::size_t axis = 0; axis < 2; ++axis)
        low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
    const double side = std::max(high[0] - low[0], high[1] - low[1]);
    PointTree tree(low, high);
    std::vector<Point2> points;
    Random random(3);
    std::size_t near = 0;
    for (const Point2& p : all) {
      double radius = side;
      for (int k = 0; k < 8; ++k, radius /= 8) {
        const Point2 except = points.empty() ? p : points[random.below(points.size())];
        const Point2 at{{p[0] + radius * random.unit(), p[1]}};
        const bool expected = any_within_by_looking(points, at, radius, except);
        ASSERT_EQ(tree.any_within(at, radius, except), expected) << dataset;
        near += expected;
      }
      tree.insert(p);
      points.push_back(p);
    }
    EXPECT_GT(near, 100U);
    EXPECT_LT(near, 8 * all.size() - 100);
    EXPECT_EQ(tree.size(), all.size());
  }
}

TEST(PointTree, TakesWhatIsExactlyAsFarForNotNear) {
  PointTree tree({{0, 0}}, {{8, 8}});
  tree.insert({{3, 4}});
  EXPECT_FALSE(tree.any_within({{0, 0}}, 5, {{8, 8}}));
  EXPECT_TRUE(tree.any_within({{0, 0}}, std::nextafter(5.0, 6.0), {{8, 8}}));
  EXPECT_FALSE(tree.any_within({{0, 0}}, 6, {{3, 4}})) << "but for the one excepted";
}

TEST(PointTree, TakesManyPointsThatDoublesHardlyTellApart) {
  PointTree tree({{1, 1}}, {{1 + 0x1p-40, 1 + 0x1p-40}});
  for (int i = 0; i < 40; ++i) tree.insert({{1 + i * 0x1p-52, 1}});
  EXPECT_TRUE(tree.any_within({{1, 1}}, 0x1p-52 * 1.5, {{1, 1}}));
  EXPECT_FALSE(tree.any_within({{1, 1}}, 0x1p-53, {{1, 1}}));
}

TEST(Spacing, GrowsGeometricallyLayerByLayer) {
  const Spacing spacing{1e-4, 1.25, 0.5};
  double distance = 0, height = 1e-4;
  for (int layer = 0; layer < 30; ++layer, height *= 1.25) {
    EXPECT_NEAR(spacing.at(distance), height, 1e-12);
    distance += height;
  }
  EXPECT_EQ(spacing.at(100), 0.5);
}

TEST(Spacing, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double wall : {0.0, -1e-4, nan, infinity})
    EXPECT_NE((Spacing{wall, 1.3, 10}.refuse()), "") << wall;
  for (const double growth : {0.0, 0.9, -1.0, nan})
    EXPECT_NE((Spacing{1e-4, growth, 10}.refuse()), "") << growth;
  for (const double most : {0.0, 1e-5, nan, infinity})
    EXPECT_NE((Spacing{1e-4, 1.3, most}.refuse()), "") << most;
  EXPECT_EQ((Spacing{1e-4, 1, 1e-4}.refuse()), "");
}

}  // namespace
}  // namespace tribunal::stretching
