// No two shores meet, nor one itself, once the smaller islands that do are gone; and each has a point inside.
#include "datasets/random.hpp"
#include "tests/datasets/shore_world.hpp"

#include <gtest/gtest.h>

namespace tribunal::shores {
namespace {

Shore island(std::int32_t polygon, std::vector<Place> places) { return {polygon, true, std::move(places)}; }

TEST(MeetingIslands, GoTheSmallerFirst) {
  const Shore large = island(1, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const std::vector<std::pair<std::vector<Place>, std::size_t>> cases{
      {{{10, 5}, {15, 3}, {15, 8}}, 1},             // a vertex on an edge
      {{{5, 5}, {15, 3}, {15, 8}}, 1},              // crossing
      {{{10, 2}, {15, 2}, {15, 8}, {10, 8}}, 1},    // an edge along an edge
      {{{10, 0}, {15, 0}, {10, 10}}, 1},            // the same edge
      {{{10, 10}, {15, 10}, {15, 15}}, 0},          // one vertex
      {{{11, 0}, {15, 0}, {11, 10}}, 0},            // near
      {{{20, 0}, {30, 0}, {20, 10}, {30, 10}}, 1},  // itself
      {{{20, 0}, {30, 0}, {25, 0}, {25, 9}}, 1},    // itself, by a spike
  };
  for (const auto& [places, removed] : cases) {
    std::vector<Shore> shores{island(2, places), large};
    EXPECT_EQ(remove_meeting_islands(shores), removed);
    ASSERT_EQ(shores.size(), 2 - removed);
    EXPECT_EQ(shores.back().polygon, 1);
  }
}

TEST(MeetingIslands, SparesWhatGoesThroughTheWindow) {
  const Shore main{9, false, {{0, 0}, {10, 0}, {20, 0}}};
  std::vector<Shore> shores{main, island(3, {{5, -5}, {6, -5}, {6, 5}})};
  EXPECT_EQ(remove_meeting_islands(shores), 1U);
  EXPECT_EQ(shores[0].polygon, 9);
  std::vector<Shore> both{main, {8, false, {{5, -5}, {5, 5}}}};
  EXPECT_NE(reason_of([&] { remove_meeting_islands(both); }), "");
}

TEST(InnerPoints, AreInside) {
  Random random(11);
  int tried = 0;
  for (int round = 0; round < 400; ++round) {
    // A comb: x grows along the teeth and comes back along a line below them all.
    std::vector<Place> polygon;
    const auto teeth = static_cast<std::int64_t>(1 + random.below(9));
    for (std::int64_t x = 0; x < 3 * teeth; ++x)
      polygon.push_back({x + static_cast<std::int64_t>(random.below(2)) * (x % 3 == 1),
                         static_cast<std::int64_t>(random.below(60))});
    polygon.push_back({3 * teeth, -1});
    polygon.push_back(
        {-static_cast<std::int64_t>(random.below(3)), -1 - static_cast<std::int64_t>(random.below(3))});
    std::vector<Shore> simple{island(1, polygon)};
    if (remove_meeting_islands(simple) != 0) continue;
    ++tried;
    for (const bool mirrored : {false, true}) {
      std::vector<Place> turned = polygon;
      if (mirrored)
        for (Place& p : turned) p = {-p.y, -p.x};
      Place middle{0, 0};
      for (const Place& p : around_inner_point(turned)) middle = {middle.x + p.x, middle.y + p.y};
      for (Place& p : turned) p = {4 * p.x, 4 * p.y};
      ASSERT_TRUE(encloses(turned, middle)) << round;
      for (std::size_t i = 0; i < turned.size(); ++i) {
        const Place &a = turned[i], &b = turned[(i + 1) % turned.size()];
        ASSERT_FALSE(turn(a, b, middle) == 0 && std::min(a, b) <= middle && middle <= std::max(a, b))
            << round;
      }
    }
  }
  EXPECT_GT(tried, 100);
}

}  // namespace
}  // namespace tribunal::shores
