// The checker on meshes of two hundred thousand triangles: lattices, whose triangulations are known.
#include "algorithms/verify/verify.hpp"
#include "tests/faults/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tribunal::faults {
namespace {

using verify::FaultKind;
using verify::Verdict;

constexpr std::uint32_t side = 317;  // 2 * 316^2 = 199,712 triangles

/// side x side points in rows that are shifted against each other by `shear`, each cell cut along the same
/// diagonal.
struct Lattice {
  std::vector<Point2> points;
  std::vector<Triangle> triangles;

  explicit Lattice(double shear) {
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) points.push_back({{x + shear * y, static_cast<double>(y)}});
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::uint32_t corner = side * y + x;
        triangles.push_back({corner, corner + 1, corner + side});
        triangles.push_back({corner + 1, corner + side + 1, corner + side});
      }
  }
};

// All angles are acute, so every edge is locally Delaunay with room to spare.
TEST(LargeMeshes, OfAcuteTrianglesAreValidWithoutTies) {
  const Lattice lattice(0.5);
  const Verdict verdict =
      verify::verify_planar(lattice.points, {lattice.triangles, neighbours_of(lattice.triangles)});
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.sites, side * side);
  EXPECT_EQ(verdict.hull, 4 * (side - 1));
  EXPECT_EQ(verdict.ties, 0U);
}

// Every cell of a square lattice is a tie, and only its diagonal is.
TEST(LargeMeshes, OfSquareCellsAreValidWithOneTiePerCell) {
  const Lattice lattice(0);
  const Verdict verdict = verify::verify_planar(lattice.points, {lattice.triangles});
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.ties, (side - 1) * (side - 1));
}

// One fault among two hundred thousand triangles is found, here a crossing in a mesh where nothing but a
// sweep can find it in time.
TEST(LargeMeshes, WithOneCrossingHaveItNamed) {
  Lattice lattice(0.25);
  const std::uint32_t corner = side * 150 + 140;
  const auto cell = static_cast<std::uint32_t>(2 * ((side - 1) * 150 + 140));
  lattice.triangles[cell + 1] = {corner, corner + 1, corner + side + 1};
  const Verdict verdict = verify::verify_planar(lattice.points, {lattice.triangles});
  const auto crossing =
      std::find_if(verdict.faults.begin(), verdict.faults.end(),
                   [](const verify::Fault& fault) { return fault.kind == FaultKind::crossing_edges; });
  ASSERT_NE(crossing, verdict.faults.end());
  EXPECT_EQ(crossing->simplices, (std::vector<std::uint32_t>{cell, cell + 1}));
  std::vector<std::uint32_t> points = crossing->points;
  std::sort(points.begin(), points.end());
  EXPECT_EQ(points, (std::vector<std::uint32_t>{corner, corner + 1, corner + side, corner + side + 1}));
}

// Nothing is quadratic in the number of faults either.
TEST(LargeMeshes, WithEveryThirdTriangleLostAreJudged) {
  const Lattice lattice(0);
  std::vector<Triangle> rest;
  for (std::size_t t = 0; t < lattice.triangles.size(); ++t)
    if (t % 3 != 0) rest.push_back(lattice.triangles[t]);
  const Verdict verdict = verify::verify_planar(lattice.points, {rest});
  EXPECT_FALSE(verdict.valid());
  EXPECT_EQ(verdict.faults.size(), 100U);
}

}  // namespace
}  // namespace tribunal::faults
