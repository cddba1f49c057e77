// Shores cut at bins come together again, and the sea that they bound is what is not land.
#include "datasets/random.hpp"
#include "tests/datasets/shore_world.hpp"

#include <gtest/gtest.h>

#include <map>

namespace tribunal::shores {
namespace {

TEST(Shores, AnIslandAcrossBinsIsOneRing) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));           // two bins
  world.add(box(4 * side - 100, 4 * side + 100, 9 * side - 30, 9 * side + 30));  // four, around their corner
  world.add(box(7 * side - 9, 10 * side + 9, 8 * side - 9, 11 * side + 9));      // sixteen
  world.add(box(3 * side + 100, 3 * side + 200, 9 * side + 7, 9 * side + 50));   // one
  const auto shores = assemble(world.binned(), everything);
  ASSERT_EQ(shores.size(), 4U);
  std::map<std::int32_t, Wide> areas;
  for (const Shore& shore : shores) {
    EXPECT_TRUE(shore.closed);
    areas[shore.polygon] = doubled_area(shore.places) / (Wide{2} * step * step);
  }
  EXPECT_TRUE(areas[0] == 300 * 43 && areas[1] == 200 * 60 && areas[3] == 100 * 43);
  EXPECT_TRUE(areas[2] == Wide{3 * side + 18} * (3 * side + 18));
}

TEST(Shores, OnlyThoseOfTheSeaCount) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  EXPECT_TRUE(assemble(world.binned(2), everything).empty());
}

TEST(Shores, ARingOfTwoPointsIsNoIsland) {
  World world;
  world.add({{100, 100}, {200, 100}});
  EXPECT_TRUE(assemble(world.binned(), everything).empty());
}

/// Random boxes that keep apart, seen through a window that cuts many: the outlines and islands enclose, by
/// even and odd, just what no box covers.
TEST(Shores, WhatTheyEncloseIsTheSea) {
  Random random(5);
  std::size_t cuts = 0;
  for (int round = 0; round < 60; ++round) {
    World world;
    std::vector<std::vector<Place>> lands;
    std::vector<std::array<std::int64_t, 4>> boxes;
    for (int attempt = 0; attempt < 60; ++attempt) {
      const auto coordinate = [&](std::int64_t from, std::uint64_t range) {
        const std::int64_t c = from + static_cast<std::int64_t>(random.below(range));
        return c % side == 0 ? c + 1 : c;
      };
      const std::int64_t west = coordinate(5 * side, 6 * side), south = coordinate(5 * side, 6 * side),
                         east = coordinate(west + 2, 2 * side), north = coordinate(south + 2, 2 * side);
      const bool free = std::ranges::none_of(boxes, [&](const auto& b) {
        return west <= b[1] && b[0] <= east && south <= b[3] && b[2] <= north;
      });
      if (!free) continue;
      boxes.push_back({west, east, south, north});
      world.add(box(west, east, south, north));
      lands.push_back({place(west, south), place(east, south), place(east, north), place(west, north)});
    }
    const Window window = window_of_degrees(65, 105, -25, 15);
    std::vector<Shore> seen = cut(assemble(world.binned(), window), window);
    EXPECT_EQ(remove_meeting_islands(seen), 0U);
    auto outlines = close_along_border(seen, window);
    for (const auto& outline : outlines) EXPECT_TRUE(doubled_area(outline) > 0);
    for (const Shore& shore : seen) {
      if (shore.closed) outlines.push_back(shore.places);
      cuts += !shore.closed;
    }
    for (int i = 0; i < 300; ++i) {
      const auto within = [&](std::int64_t low, std::int64_t high) {
        return low + 1 +
               2 * static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(high - low) / 2));
      };
      const Place p{within(window.low.x, window.high.x), within(window.low.y, window.high.y)};
      const auto holds = [&](const auto& polygon) { return encloses(polygon, p); };
      ASSERT_EQ(std::ranges::count_if(outlines, holds) % 2 == 1, std::ranges::none_of(lands, holds)) << round;
    }
  }
  EXPECT_GT(cuts, 300U);
}

TEST(Shores, SlantingCutsLieOnTheBorderAndBesideTheEdge) {
  const Window window = window_of_degrees(10, 20, 0, 10);
  // A triangle that covers the corner in the south-west, in thirds that no lattice has.
  const std::int64_t d = steps_per_degree;
  const Shore land{0, true, {{9 * d, -d}, {17 * d, -d}, {9 * d, 2 * d}}};
  const auto seen = cut({land}, window);
  ASSERT_EQ(seen.size(), 1U);
  ASSERT_EQ(seen[0].places.size(), 2U);
  const auto [enters, leaves] = std::array{seen[0].places[0], seen[0].places[1]};
  EXPECT_EQ(enters.y, window.low.y);
  EXPECT_EQ(leaves.x, window.low.x);
  // Half a step off at most: twice the distance along the border times the other side.
  const auto off = [&](const Place& p) {
    const Wide twice = Wide{-8 * d} * (p.y + d) - Wide{3 * d} * (p.x - 17 * d);
    return twice < 0 ? -twice : twice;
  };
  EXPECT_TRUE(2 * off(enters) <= Wide{3 * d} && 2 * off(leaves) <= Wide{8 * d});
  const auto outlines = close_along_border(seen, window);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines[0].size(), 5U);
  EXPECT_TRUE(doubled_area(outlines[0]) > 0);
}

TEST(Shores, AnEdgeMayCrossTheWholeWindow) {
  const Window window = window_of_degrees(10, 20, 0, 10);
  const std::int64_t d = steps_per_degree;
  const auto seen =
      cut({{0, true, {{12 * d, -d}, {14 * d, -d}, {14 * d, 11 * d}, {12 * d, 11 * d}}}}, window);
  EXPECT_EQ(seen.size(), 2U);
  EXPECT_EQ(close_along_border(seen, window).size(), 2U);
}

TEST(Shores, OneThatEndsInTheSeaIsRefused) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  BinnedShores binned = world.binned();
  for (BinnedShores::Piece& piece : binned.pieces)
    if (piece.entry() == 3) piece.code += 1 << 6;  // to another level
  EXPECT_EQ(reason_of([&] { cut(assemble(binned, everything), everything); }),
            "a shore ends in the sea at 10 degrees east, 0 north");
}

TEST(Shores, ThoseThatBeginInOnePlaceAreRefused) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  BinnedShores binned = world.binned();
  binned.pieces[0].polygon = binned.pieces[1].polygon;
  binned.pieces.push_back(binned.pieces[0]);
  for (auto& bin : binned.bins)
    if (bin.pieces > 0) bin = {0, static_cast<std::int32_t>(binned.pieces.size())};
  EXPECT_NE(reason_of([&] { assemble(binned, everything); }).find("in one place"), std::string::npos);
}

}  // namespace
}  // namespace tribunal::shores
