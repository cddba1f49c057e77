// Law: however it is found, the greedy triangulation has the edges that its definition says, in that order.
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/dataset.hpp"
#include "tests/greedy/support.hpp"

namespace tribunal::greedy {
namespace {

void expect_definition(const LatticeSites& sites, std::string_view backend) {
  const Plane plane(points_of(sites), backend);
  ASSERT_TRUE(plane.is_bound());
  const std::vector<Edge> expected = by_definition(sites);
  for (const Method& method : methods) {
    const Result found = method.run({plane.problem()});
    ASSERT_EQ(found.edges, expected) << method.name << " " << backend;
    // Euler: what has 3n - 3 - b edges has 2n - 2 - b triangles.
    EXPECT_EQ(found.triangles.size(), expected.size() + 1 - sites.size()) << method.name;
  }
}

TEST(Definition, RandomSitesFromCrowdedToSparse) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    const std::uint64_t side = std::array<std::uint64_t, 4>{6, 9, 30, 4096}[seed % 4];
    const LatticeSites sites = random_sites(random, 3 + random.below(26), side);
    if (all_on_a_line(sites)) continue;
    SCOPED_TRACE(seed);
    expect_definition(sites, seed % 5 == 0 ? "gmp" : "filtered");
  }
}

TEST(Definition, EverySmallLatticeSet) {
  for (int mask = 7; mask < 512; ++mask) {
    LatticeSites sites;
    for (int i = 0; i < 9; ++i)
      if (mask >> i & 1) sites.push_back({i * 5 % 9 % 3, i * 5 % 9 / 3});
    if (sites.size() < 3 || all_on_a_line(sites)) continue;
    SCOPED_TRACE(mask);
    expect_definition(sites, "filtered");
  }
}

/// The whole grid has four lengths of edges for hundreds of ties; circles have none that cross nothing.
TEST(Definition, GridAndCircle) {
  LatticeSites grid, circle;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) grid.push_back({x, y});
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65 || (x == 0 && y == 0)) circle.push_back({x, y});
  expect_definition(grid, "gmp");
  expect_definition(circle, "gmp");
}

TEST(Agreement, OnEveryDatasetInEdgesAndOrder) {
  for (const Dataset& dataset : datasets()) {
    std::vector<Point2> points;
    for (const Point2& p : dataset.generate(90, 7))
      if (points.size() < 90 && std::find(points.begin(), points.end(), p) == points.end())
        points.push_back(p);
    const Plane plane(points);
    if (plane.problem().kernel.orient2d(points[0], points[1], points[plane.problem().sites[2]]) == Sign::zero)
      continue;
    const Result first = by_list({plane.problem()});
    for (const Method& method : methods) {
      const Result found = method.run({plane.problem()});
      EXPECT_EQ(found.edges, first.edges) << method.name << " " << dataset.about.name;
      EXPECT_EQ(found.triangles, first.triangles) << method.name << " " << dataset.about.name;
    }
  }
}

/// Neither the order of insertion nor the Delaunay triangulation that breaks ties by it shows.
TEST(Agreement, TheOrderOfInsertionDoesNotMatter) {
  for (const std::string_view name : {"grid", "circle", "uniform", "duplicates"}) {
    const auto points = find_dataset(name)->generate(400, 3);
    const auto bound = find_backend("filtered")->bind2(points);
    std::set<std::uint64_t> digests;
    for (const Order order : {Order::random, Order::input, Order::x, Order::hilbert}) {
      const Triangulation t = triangulate(points, insertion_order(points, order, 5), *std::get<0>(bound),
                                          *find_planar_algorithm("greedy"));
      ASSERT_EQ(t.outcome, Outcome::ok) << t.reason;
      digests.insert(digest(t.triangles));
    }
    EXPECT_EQ(digests.size(), 1U) << name;
  }
}

TEST(Pool, TheHullCountsItsCollinearSites) {
  for (const Dataset& dataset : datasets()) {
    const auto points = dataset.generate(60, 2);
    const auto bound = find_backend("gmp")->bind2(points);
    const Triangulation t = triangulate(points, insertion_order(points, Order::random, 1),
                                        *std::get<0>(bound), *find_planar_algorithm("bowyer"));
    if (t.dimension < 2) continue;
    std::vector<Index> sites;
    for (Index v = 0; v < points.size(); ++v)
      if (std::none_of(t.duplicates.begin(), t.duplicates.end(), [v](auto& d) { return d.first == v; }))
        sites.push_back(v);
    EXPECT_EQ(hull_size({points, sites, *std::get<0>(bound)}), t.hull) << dataset.about.name;
  }
}

/// Step 5 by a full scan asks more and answers the same.
TEST(Pool, AFullScanFindsTheSameEdges) {
  Random random(1);
  const Plane plane(points_of(random_sites(random, 60, 1000)));
  AcceptedList early(plane.problem(), false), full(plane.problem(), true);
  const GreedyEdges a = triangulate_from_pool({plane.problem()}, early);
  const GreedyEdges b = triangulate_from_pool({plane.problem()}, full);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.candidates, b.candidates);
  EXPECT_LE(a.candidates, 60U * 59 / 2);
  EXPECT_LT(early.tests(), full.tests());
}

}  // namespace
}  // namespace tribunal::greedy
