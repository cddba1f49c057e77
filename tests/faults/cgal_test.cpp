// CGAL beside the checker: its meshes are valid, and on any triangulation both count the same edges.
#include "algorithms/verify/verify.hpp"
#include "tests/faults/cgal_oracle.hpp"
#include "tests/faults/flips.hpp"
#include "tests/faults/mesh_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tribunal::faults {
namespace {

using verify::Verdict;
using verify::verify_planar;

double rounded(double value, double unit) { return std::round(value / unit) * unit; }

/// Larger point sets than the tests can triangulate by themselves; kind after kind.
std::vector<Point2> make_points(std::uint32_t i) {
  Random random(0xC6A1 + i);
  const std::uint64_t n = 50 + random.below(1500);
  std::vector<Point2> points;
  for (std::uint64_t k = 0; k < n; ++k) {
    const double x = random.unit(), y = random.unit(), angle = 6.283185307179586 * x;
    switch (i % 6) {
      case 0:
        points.push_back({{x, y}});
        break;
      case 1:
        points.push_back({{rounded(x, 0x1p-5), rounded(y, 0x1p-5)}});
        break;  // a grid with copies
      case 2:
        points.push_back({{std::cos(angle), std::sin(angle)}});
        break;  // near a circle
      case 3:
        points.push_back({{x, 0.5 * x + 0x1p-50 * std::floor(8 * y)}});
        break;  // near a line
      case 4:
        points.push_back({{std::floor(4 * x) + 1e-9 * random.unit(), std::floor(4 * y) + 1e-9 * y}});
        break;
      default:
        points.push_back({{std::ldexp(x, -static_cast<int>(random.below(60))), y}});
        break;
    }
  }
  return points;
}

void expect_same_edges(const std::vector<Point2>& points, const std::vector<Triangle>& triangles) {
  const Verdict verdict = verify_planar(points, {triangles}, {verify::Kind::delaunay, 1000000});
  const CgalEdges edges = cgal_judges_edges(points, triangles);
  EXPECT_EQ(verdict.found, edges.non_delaunay);
  EXPECT_EQ(verdict.ties, edges.ties);
}

TEST(Cgal, MakesMeshesThatTheCheckerFindsValid) {
  for (std::uint32_t i = 0; i < 120; ++i) {
    SCOPED_TRACE("points " + std::to_string(i));
    const std::vector<Point2> points = make_points(i);
    const CgalMesh mesh = cgal_delaunay(points);
    EXPECT_TRUE(mesh.valid);
    const Verdict verdict = verify_planar(points, {mesh.triangles, neighbours_of(mesh.triangles)});
    EXPECT_TRUE(verdict.valid()) << verdict.faults[0].detail;
    expect_same_edges(points, mesh.triangles);
  }
}

TEST(Cgal, FindsTheSampleMeshesValidToo) {
  for (const Sample& sample : make_samples(20 * families)) {
    const std::vector<Point2> points = as_points(sample.points);
    EXPECT_EQ(cgal_judges_edges(points, sample.triangles).non_delaunay, 0U);
    EXPECT_EQ(cgal_delaunay(points).triangles.size(), sample.triangles.size());
    expect_same_edges(points, sample.triangles);
  }
}

// Random flips leave a triangulation, with some edges that are not locally Delaunay: both count the same.
TEST(Cgal, CountsTheSameEdgesThatAreNotDelaunay) {
  Random random(32);
  for (Sample& sample : make_samples(20 * families)) {
    flip_at_random(sample, random, 12);
    expect_same_edges(as_points(sample.points), sample.triangles);
  }
}

}  // namespace
}  // namespace tribunal::faults
