// No false alarms: valid meshes of every kind are found valid, and what else the verdict says of them is
// true.
#include "tests/faults/flips.hpp"
#include "tests/faults/mesh_map.hpp"
#include "tests/faults/naive_checker.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tribunal::faults {
namespace {

using verify::Kind;
using verify::Verdict;

constexpr std::uint32_t sample_count = 30 * families;

Verdict judge(const std::vector<LatticePoint>& points, const std::vector<Triangle>& triangles,
              Kind kind = Kind::delaunay) {
  const std::vector<Triangle> neighbours = neighbours_of(triangles);
  return verify::verify_planar(as_points(points), {triangles, neighbours}, {kind, 100});
}

std::string first_fault(const Verdict& verdict) {
  return verdict.valid() ? ""
                         : std::string(to_string(verdict.faults[0].kind)) + ": " + verdict.faults[0].detail;
}

/// Interior edges whose four points lie on one circle, by the determinant.
std::uint64_t count_ties(const Sample& sample) {
  const MeshMap map(sample.triangles);
  const auto& p = sample.points;
  std::uint64_t twice = 0;
  for (const Side& side : map.interior())
    twice += in_circle(p[side.from], p[side.to], p[side.apex], p[map.across(side)->apex]) == 0;
  return twice / 2;
}

TEST(ValidMeshes, AreValid) {
  for (std::uint32_t i = 0; i < sample_count; ++i) {
    const Sample sample = make_sample(i);
    SCOPED_TRACE("sample " + std::to_string(i) + ", " + std::string(sample.family));
    ASSERT_TRUE(naive_findings(sample.points, sample.triangles).empty());
    ASSERT_FALSE(naive_overlap(sample.points, sample.triangles));
    const Verdict verdict = judge(sample.points, sample.triangles);
    EXPECT_EQ(first_fault(verdict), "");
    EXPECT_EQ(verdict.found, 0U);
    EXPECT_EQ(verdict.dimension, 2);
    EXPECT_EQ(verdict.sites, distinct_sites(sample.points).size());
    EXPECT_EQ(verdict.hull, MeshMap(sample.triangles).hull().size());
    EXPECT_EQ(verdict.ties, count_ties(sample));
  }
}

// Neither the order of triangles, nor the first corner, nor the size and place of the coordinates' unit
// matters.
TEST(ValidMeshes, StayValidWhenListedOtherwiseAndScaled) {
  Random random(22);
  for (std::uint32_t i = 0; i < sample_count; ++i) {
    Sample sample = make_sample(i);
    random.shuffle(std::span(sample.triangles));
    for (Triangle& t : sample.triangles)
      if (random.below(2) == 1) t = {t[1], t[2], t[0]};
    for (const double unit : {0x1p-1074, 0x1p-500, 0x1p+990}) {
      std::vector<Point2> points = as_points(sample.points);
      for (Point2& p : points) p = {{p[0] * unit, p[1] * unit}};
      EXPECT_TRUE(verify::verify_planar(points, {sample.triangles}).valid())
          << "sample " << i << " unit " << unit;
    }
  }
}

// A triangulation that is not Delaunay is valid as a triangulation, and no more.
TEST(ValidMeshes, NeedNotBeDelaunayWhereOnlyATriangulationIsAskedFor) {
  Random random(23);
  int not_delaunay = 0;
  for (std::uint32_t i = 0; i < sample_count; ++i) {
    Sample sample = make_sample(i);
    flip_at_random(sample, random, 10);
    EXPECT_EQ(first_fault(judge(sample.points, sample.triangles, Kind::triangulation)), "") << "sample " << i;
    const std::set<Finding> naive = naive_findings(sample.points, sample.triangles);
    const Verdict verdict = judge(sample.points, sample.triangles);
    EXPECT_EQ(verdict.valid(), naive.empty()) << "sample " << i;
    EXPECT_EQ(verdict.found, naive.size()) << "sample " << i;
    not_delaunay += !verdict.valid();
  }
  EXPECT_GT(not_delaunay, 100);
}

// On points without four on an empty circle there is one Delaunay triangulation: the triples whose circle is
// empty. A triangulation passes exactly when it is that set.
TEST(ValidMeshes, OfGeneralPointsAreExactlyTheEmptyCircleTriples) {
  Random random(24);
  int unchanged = 0, changed = 0;
  for (int round = 0; round < 60; ++round) {
    Sample sample{"general", {}, {}};
    const std::uint64_t n = 5 + random.below(56);
    for (std::uint64_t i = 0; i < n; ++i)
      sample.points.push_back({static_cast<std::int64_t>(random.below(1 << 17)),
                               static_cast<std::int64_t>(random.below(1 << 17))});
    const auto canonical = [](std::vector<Triangle> triangles) {
      for (Triangle& t : triangles) std::sort(t.begin(), t.end());
      return std::set<Triangle>(triangles.begin(), triangles.end());
    };
    sample.triangles = triangulate_by_definition(sample.points, distinct_sites(sample.points), random);
    const std::set<Triangle> by_definition = canonical(sample.triangles);
    EXPECT_EQ(judge(sample.points, sample.triangles).ties, 0U);
    flip_at_random(sample, random, static_cast<int>(random.below(3)));
    const bool same = canonical(sample.triangles) == by_definition;
    EXPECT_EQ(judge(sample.points, sample.triangles).valid(), same) << "round " << round;
    ++(same ? unchanged : changed);
  }
  EXPECT_GT(unchanged, 10);
  EXPECT_GT(changed, 10);
}

}  // namespace
}  // namespace tribunal::faults
