// Degenerate inputs end well, with every algorithm.
#include "tests/conformance/run.hpp"

namespace tribunal {
namespace {

class Degenerate : public testing::TestWithParam<const PlanarAlgorithm*> {
 protected:
  Triangulation run(const std::vector<Point2>& points, std::string_view backend = "gmp") const {
    return tribunal::run(points, *GetParam(), backend, Order::input);
  }
  verify::Verdict check(const std::vector<Point2>& points, const Triangulation& t) const {
    return tribunal::check(points, t, GetParam()->about.promise);
  }
};

TEST_P(Degenerate, NoPointsAreRefused) { EXPECT_EQ(run({}).outcome, Outcome::refused_input); }

TEST_P(Degenerate, OnePointHasDimensionZero) {
  const Triangulation t = run({{3, 4}});
  EXPECT_EQ(t.outcome, Outcome::ok);
  EXPECT_EQ(t.dimension, 0);
  EXPECT_EQ(t.hull, 1U);
}

TEST_P(Degenerate, OnePointManyTimes) {
  const Triangulation t = run({{3, 4}, {3, 4}, {3, 4}});
  EXPECT_EQ(t.dimension, 0);
  const std::vector<std::pair<Index, Index>> duplicates{{1, 0}, {2, 0}};
  EXPECT_EQ(t.duplicates, duplicates);
}

TEST_P(Degenerate, MinusZeroIsZero) {
  const Triangulation t = run({{0.0, -0.0}, {-0.0, 0.0}, {1, 0}, {0, 1}});
  EXPECT_EQ(t.duplicates.size(), 1U);
  EXPECT_EQ(t.triangles.size(), 1U);
}

TEST_P(Degenerate, CollinearPointsFormAPathAlongTheLine) {
  const Triangulation t = run({{2, 4}, {0, 0}, {3, 6}, {1, 2}, {2, 4}});
  EXPECT_EQ(t.outcome, Outcome::ok);
  EXPECT_EQ(t.dimension, 1);
  const std::vector<Edge> path{{1, 3}, {3, 0}, {0, 2}};
  EXPECT_EQ(t.edges, path);
  EXPECT_TRUE(t.triangles.empty());
}

TEST_P(Degenerate, VerticalLine) {
  const Triangulation t = run({{1, 5}, {1, -5}, {1, 0}});
  const std::vector<Edge> path{{1, 2}, {2, 0}};
  EXPECT_EQ(t.edges, path);
}

TEST_P(Degenerate, AllButOneCollinear) {
  std::vector<Point2> points;
  for (int i = 0; i < 50; ++i) points.push_back({double(i), double(2 * i)});
  points.push_back({7, 3});
  const Triangulation t = run(points);
  EXPECT_EQ(t.outcome, Outcome::ok);
  EXPECT_EQ(t.triangles.size(), 49U);
  EXPECT_EQ(t.hull, 51U);
  EXPECT_TRUE(check(points, t).valid()) << faults_of(check(points, t));
}

TEST_P(Degenerate, CollinearHullPointsStayOnTheHull) {
  const std::vector<Point2> points{{0, 0}, {4, 0}, {2, 3}, {2, 0}, {1, 0}, {3, 0}, {6, 0}, {-2, 0}};
  const Triangulation t = run(points);
  EXPECT_EQ(t.hull, 8U);
  EXPECT_TRUE(check(points, t).valid()) << faults_of(check(points, t));
}

TEST_P(Degenerate, UnitSquareHasTwoTriangles) {
  const std::vector<Point2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Triangulation t = run(points);
  EXPECT_EQ(t.triangles.size(), 2U);
  EXPECT_TRUE(check(points, t).valid());
}

TEST_P(Degenerate, SiteOnEveryEdgeOfATriangleThenInside) {
  const std::vector<Point2> points{{0, 0}, {6, 0}, {0, 6}, {3, 0}, {3, 3}, {0, 3}, {2, 2}, {1, 1}};
  const Triangulation t = run(points);
  EXPECT_EQ(t.outcome, Outcome::ok);
  EXPECT_TRUE(check(points, t).valid()) << faults_of(check(points, t));
}

TEST_P(Degenerate, ExtremeMagnitudes) {
  const std::vector<Point2> points{{-0x1p1000, -0x1p1000}, {0x1p1000, -0x1p999}, {0, 0x1p1000},
                                   {0x1p-1074, 0},         {0, 0x1p-1074},       {1, 1},
                                   {0x1p-500, 3},          {-7, 0x1p500}};
  const Triangulation t = run(points);
  EXPECT_EQ(t.outcome, Outcome::ok) << t.reason;
  EXPECT_TRUE(check(points, t).valid()) << faults_of(check(points, t));
}

// Every ordered choice of up to six points of the 3 x 3 lattice, repetition allowed only through order:
// exhaustive.
TEST_P(Degenerate, AllSmallLatticeSets) {
  const auto lattice = [](int i) { return Point2{double(i % 3), double(i / 3)}; };
  int sets = 0;
  for (int mask = 1; mask < 512; ++mask) {
    std::vector<Point2> points;
    for (int i = 0; i < 9; ++i)
      if (mask >> i & 1) points.push_back(lattice((i * 5) % 9));
    const Triangulation t = run(points, "double");  // exact on this lattice
    ASSERT_EQ(t.outcome, Outcome::ok) << mask << ": " << t.reason;
    ASSERT_TRUE(check(points, t).valid()) << mask << "\n" << faults_of(check(points, t));
    ++sets;
  }
  EXPECT_EQ(sets, 511);
}

std::vector<const PlanarAlgorithm*> all_algorithms() {
  std::vector<const PlanarAlgorithm*> all;
  for (const auto& algorithm : planar_algorithms()) all.push_back(&algorithm);
  return all;
}

std::string algorithm_name(const testing::TestParamInfo<const PlanarAlgorithm*>& info) {
  return test_name(info.param->about.name);
}

INSTANTIATE_TEST_SUITE_P(All, Degenerate, testing::ValuesIn(all_algorithms()), algorithm_name);

}  // namespace
}  // namespace tribunal
