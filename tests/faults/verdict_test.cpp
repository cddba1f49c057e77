// What the verdict says beyond valid or not: dimension, order and number of faults, hostile arguments.
#include "algorithms/verify/verify.hpp"
#include "tests/faults/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace tribunal::faults {
namespace {

using verify::Fault;
using verify::FaultKind;
using verify::Verdict;
using verify::verify_planar;

const std::vector<Triangle> no_triangles;

TEST(Verdict, KnowsTheDimensionOfThePoints) {
  const auto dimension = [](const std::vector<Point2>& points) {
    const Verdict verdict = verify_planar(points, {no_triangles});
    EXPECT_EQ(verdict.valid(), verdict.dimension < 2);
    return verdict.dimension;
  };
  EXPECT_EQ(dimension({}), -1);
  EXPECT_EQ(dimension({{{1, 2}}}), 0);
  EXPECT_EQ(dimension({{{0.0, 2}}, {{-0.0, 2}}}), 0);
  EXPECT_EQ(dimension({{{1, 2}}, {{3, 4}}}), 1);
  EXPECT_EQ(dimension({{{0, 0}}, {{1, 3}}, {{2, 6}}, {{1, 3}}}), 1);
  EXPECT_EQ(dimension({{{0.1, 0.1}}, {{0.2, 0.2}}, {{0.3, 0.3}}, {{1e300, 1e300}}, {{-5e-324, -5e-324}}}), 1);
  EXPECT_EQ(dimension({{{0.1, 0.1}}, {{0.2, 0.2}}, {{0.3, std::nextafter(0.3, 1)}}}), 2);
}

TEST(Verdict, AllowsNoTrianglesOnALine) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 1}}};
  for (const Triangle t : {Triangle{0, 1, 2}, Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{0, 1, 9}}) {
    const std::vector<Triangle> triangles{t};
    EXPECT_FALSE(verify_planar(points, {triangles}).valid());
  }
  const Verdict verdict = verify_planar(points, {no_triangles});
  EXPECT_EQ(verdict.sites, 3U);
  EXPECT_EQ(verdict.hull, 3U);
}

TEST(Verdict, OfAnEmptyMeshNamesEverySiteAndEveryEdgeOfTheHull) {
  const std::vector<Point2> points{{{0, 0}}, {{4, 0}}, {{4, 4}}, {{0, 4}}, {{1, 2}}, {{4, 2}}};
  const Verdict verdict = verify_planar(points, {no_triangles});
  const auto count = [&](FaultKind kind) {
    return std::count_if(verdict.faults.begin(), verdict.faults.end(),
                         [=](const Fault& f) { return f.kind == kind; });
  };
  EXPECT_EQ(count(FaultKind::missing_site), 6);
  EXPECT_EQ(count(FaultKind::hull_mismatch), 5);
  EXPECT_EQ(count(FaultKind::wrong_count), 1);
  EXPECT_EQ(verdict.hull, 5U);
}

TEST(Verdict, SortsFaultsByKindThenTriangles) {
  Sample sample = make_sample(0);
  for (Triangle& t : sample.triangles) std::swap(t[0], t[1]);
  sample.triangles.push_back({0, 0, 1});
  sample.triangles.push_back({0, 1, 100000});
  const Verdict verdict = verify_planar(as_points(sample.points), {sample.triangles});
  EXPECT_TRUE(
      std::is_sorted(verdict.faults.begin(), verdict.faults.end(), [](const Fault& a, const Fault& b) {
        return std::tie(a.kind, a.simplices, a.points) < std::tie(b.kind, b.simplices, b.points);
      }));
  EXPECT_EQ(verdict.faults.front().kind, FaultKind::index_out_of_range);
}

// However few faults are kept, an invalid mesh is not valid, and every kind keeps its share.
TEST(Verdict, KeepsAtMostMaxFaultsAndEveryKindAmongThem) {
  Sample sample = make_sample(0);
  const auto turned = static_cast<std::uint64_t>(sample.triangles.size());
  for (Triangle& t : sample.triangles) std::swap(t[0], t[1]);
  sample.triangles.push_back({0, 0, 1});
  const std::vector<Point2> points = as_points(sample.points);
  const Verdict all = verify_planar(points, {sample.triangles}, {verify::Kind::delaunay, 10000});
  EXPECT_EQ(all.found, turned + 2);  // and a repeated corner, and the count
  EXPECT_EQ(all.faults.size(), turned + 2);
  for (const std::size_t limit : {0U, 1U, 2U, 3U, 5U}) {
    const Verdict verdict = verify_planar(points, {sample.triangles}, {verify::Kind::delaunay, limit});
    EXPECT_EQ(verdict.faults.size(), std::max<std::size_t>(limit, 1));
    EXPECT_EQ(verdict.found, turned + 2);
    EXPECT_FALSE(verdict.valid());
    if (limit < 3) continue;
    EXPECT_EQ(verdict.faults.front().kind, FaultKind::repeated_corner);
    EXPECT_EQ(verdict.faults.back().kind, FaultKind::wrong_count);
  }
}

TEST(Verdict, SaysTheSameTwice) {
  Sample sample = make_sample(1);
  sample.triangles.resize(sample.triangles.size() / 2);
  const Verdict first = verify_planar(as_points(sample.points), {sample.triangles});
  const Verdict second = verify_planar(as_points(sample.points), {sample.triangles});
  ASSERT_EQ(first.faults.size(), second.faults.size());
  for (std::size_t i = 0; i < first.faults.size(); ++i) {
    EXPECT_EQ(first.faults[i].detail, second.faults[i].detail);
    EXPECT_EQ(first.faults[i].detail.find('\n'), std::string::npos);
  }
}

TEST(Verdict, RefusesPointsThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const std::vector<Point2> points{{{0, 0}}, {{1, bad}}, {{0, 1}}};
    try {
      verify_planar(points, {no_triangles});
      ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("point 1"), std::string::npos);
    }
  }
}

TEST(Verdict, NamesRowsOfNeighboursThatAreNotOnePerTriangle) {
  const Sample sample = make_sample(0);
  std::vector<Triangle> neighbours = neighbours_of(sample.triangles);
  neighbours.pop_back();
  const Verdict verdict = verify_planar(as_points(sample.points), {sample.triangles, neighbours});
  ASSERT_EQ(verdict.faults.size(), 1U);
  EXPECT_EQ(verdict.faults[0].kind, FaultKind::wrong_neighbour);
}

}  // namespace
}  // namespace tribunal::faults
