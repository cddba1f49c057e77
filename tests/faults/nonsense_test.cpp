// Meshes that nobody meant: any numbers at all get a verdict, and it is the naive checker's.
#include "tests/faults/agreement.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tribunal::faults {
namespace {

/// A few points on a small grid, many of them equal or in line.
std::vector<LatticePoint> crowded_points(Random& random, std::uint64_t most) {
  std::vector<LatticePoint> points;
  const std::uint64_t width = 2 + random.below(6);
  for (std::uint64_t i = random.below(most + 1); i > 0; --i)
    points.push_back(
        {static_cast<std::int64_t>(random.below(width)), static_cast<std::int64_t>(random.below(width))});
  return points;
}

/// Triangles of random points; one index in `rare` is any 32 bits at all, none when `rare` is 0.
std::vector<Triangle> random_triangles(Random& random, std::uint64_t most, std::uint64_t points,
                                       std::uint64_t rare) {
  const auto index = [&] {
    const bool wild = points == 0 || (rare != 0 && random.below(rare) == 0);
    return static_cast<std::uint32_t>(wild ? random.bits() : random.below(points));
  };
  std::vector<Triangle> triangles;
  for (std::uint64_t i = random.below(most + 1); i > 0; --i) triangles.push_back({index(), index(), index()});
  return triangles;
}

TEST(Nonsense, IsJudgedAsByDefinition) {
  Random random(25);
  int judged = 0;
  for (int round = 0; round < 20000 && !testing::Test::HasFailure(); ++round) {
    const std::vector<LatticePoint> points = crowded_points(random, 14);
    const std::vector<Triangle> triangles =
        random_triangles(random, 8, points.size(), round % 2 == 0 ? 30 : 0);
    const verify::Verdict verdict =
        verify::verify_planar(as_points(points), {triangles}, {verify::Kind::delaunay, 10000});
    if (verdict.dimension < 2) {
      EXPECT_EQ(verdict.valid(), triangles.empty());
      continue;
    }
    ++judged;
    SCOPED_TRACE("round " + std::to_string(round));
    expect_agreement(points, triangles, verdict);
  }
  EXPECT_GT(judged, 10000);
}

// Neighbours may be any numbers too: that is a fault of theirs, and no other.
TEST(Nonsense, AmongNeighboursTouchesNothingElse) {
  Random random(26);
  for (std::uint32_t i = 0; i < 20 * families; ++i) {
    const Sample sample = make_sample(i);
    const std::size_t count = sample.triangles.size();
    std::vector<Triangle> neighbours;
    while (neighbours.size() < count)
      for (const Triangle& row : random_triangles(random, 8, count + 2, 10)) neighbours.push_back(row);
    neighbours.resize(count);
    const verify::Verdict verdict = verify::verify_planar(
        as_points(sample.points), {sample.triangles, neighbours}, {verify::Kind::delaunay, 10000});
    const std::vector<Triangle> right = neighbours_of(sample.triangles);
    std::uint64_t wrong = 0;
    for (std::size_t t = 0; t < count; ++t)
      for (std::size_t c = 0; c < 3; ++c) wrong += neighbours[t][c] != right[t][c];
    EXPECT_EQ(verdict.found, wrong);
    for (const Finding& f : findings(verdict)) EXPECT_EQ(f.kind, verify::FaultKind::wrong_neighbour) << f;
  }
}

}  // namespace
}  // namespace tribunal::faults
