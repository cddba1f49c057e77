// Laws: given edges go in first and all survive; what is outside a boundary stays empty.
#include "tests/greedy/support.hpp"

#include <map>

namespace tribunal::greedy {
namespace {

/// Edges that meet one another and the sites in ends alone.
std::vector<Edge> random_constraints(Random& random, const LatticeSites& sites, int tries) {
  std::vector<Edge> given;
  for (; tries > 0; --tries) {
    const Edge edge{static_cast<Index>(random.below(sites.size())),
                    static_cast<Index>(random.below(sites.size()))};
    if (edge[0] == edge[1] || meets_a_site(sites, edge)) continue;
    if (std::none_of(given.begin(), given.end(), [&](const Edge& e) {
          return undirected(e[0], e[1]) == undirected(edge[0], edge[1]) || conflict(sites, e, edge);
        }))
      given.push_back(edge);
  }
  return given;
}

TEST(Constraints, GoInFirstAndSurvive) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const LatticeSites sites = random_sites(random, 25, seed % 3 == 0 ? 8 : 300);
    if (all_on_a_line(sites)) continue;
    const Plane plane(points_of(sites), seed % 2 == 0 ? "gmp" : "filtered");
    const std::vector<Edge> given = random_constraints(random, sites, 30);
    const std::vector<Edge> expected = by_definition(sites, given);
    for (std::size_t i = 0; i < given.size(); ++i)
      ASSERT_EQ(expected[i], undirected(given[i][0], given[i][1]));
    for (const Method& method : methods) {
      const Result found = method.run({plane.problem(), given});
      ASSERT_EQ(found.edges, expected) << method.name << " seed " << seed;
      EXPECT_EQ(found.triangles.size(), expected.size() + 1 - sites.size());
    }
  }
}

/// A domain made of some triangles of a triangulation, every site at one of them: it may be nonconvex, have
/// holes, and touch itself in a site.
struct Patch {
  std::vector<Triangle> triangles;
  std::vector<Edge> boundary;

  Patch(Random& random, std::size_t sites, std::vector<Triangle> all) : triangles(std::move(all)) {
    std::vector<int> uses(sites, 0);
    for (const Triangle& t : triangles)
      for (const Index v : t) ++uses[v];
    random.shuffle(std::span(triangles));
    std::erase_if(triangles, [&](const Triangle& t) {
      if (uses[t[0]] < 2 || uses[t[1]] < 2 || uses[t[2]] < 2 || random.below(3) == 0) return false;
      for (const Index v : t) --uses[v];
      return true;
    });
    std::map<Edge, int> sides;
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
    for (const auto& [side, count] : sides)
      if (!sides.contains({side[1], side[0]})) boundary.push_back(side);
    random.shuffle(std::span(boundary));
  }

  /// Whether the middle of a segment that crosses no boundary edge is in the domain. Coordinates are doubled.
  bool admits(const LatticeSites& sites, const Edge& segment) const {
    const Site middle{sites[segment[0]].x + sites[segment[1]].x, sites[segment[0]].y + sites[segment[1]].y};
    const auto doubled = [&](Index v) { return Site{2 * sites[v].x, 2 * sites[v].y}; };
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      return area(doubled(t[0]), doubled(t[1]), middle) >= 0 &&
             area(doubled(t[1]), doubled(t[2]), middle) >= 0 &&
             area(doubled(t[2]), doubled(t[0]), middle) >= 0;
    });
  }
};

std::int64_t area_of(const LatticeSites& sites, const std::vector<Triangle>& triangles) {
  std::int64_t sum = 0;
  for (const Triangle& t : triangles) {
    EXPECT_GT(area(sites[t[0]], sites[t[1]], sites[t[2]]), 0);
    sum += area(sites[t[0]], sites[t[1]], sites[t[2]]);
  }
  return sum;
}

TEST(Boundaries, NonconvexWithHolesAndPinches) {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Random random(seed);
    const LatticeSites sites = random_sites(random, 20, seed % 4 == 0 ? 7 : 200);
    if (all_on_a_line(sites)) continue;
    const Plane plane(points_of(sites));
    const Patch patch(random, sites.size(), find_planar_algorithm("bowyer")->run(plane.problem()).triangles);
    std::vector<Edge> given = patch.boundary;
    std::vector<Edge> constraints = random_constraints(random, sites, 20);
    std::erase_if(constraints, [&](const Edge& e) {
      return !patch.admits(sites, e) ||
             std::any_of(given.begin(), given.end(), [&](const Edge& b) { return conflict(sites, b, e); });
    });
    given.insert(given.end(), constraints.begin(), constraints.end());
    const std::vector<Edge> expected =
        by_definition(sites, given, [&](const Edge& e) { return patch.admits(sites, e); });
    for (const Method& method : methods) {
      const Result found = method.run({plane.problem(), constraints, patch.boundary});
      ASSERT_EQ(found.edges, expected) << method.name << " seed " << seed;
      EXPECT_EQ(area_of(sites, found.triangles), area_of(sites, patch.triangles))
          << method.name << " seed " << seed;
    }
  }
}

/// Both sides of an edge of the boundary may be inside: it is then given in both directions.
TEST(Boundaries, ASlitIsNoHole) {
  const LatticeSites sites{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 5}, {7, 5}};
  const Plane plane(points_of(sites));
  const std::vector<Edge> boundary{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 4}};
  for (const Method& method : methods) {
    const Result found = method.run({plane.problem(), {}, boundary});
    EXPECT_EQ(area_of(sites, found.triangles), 200) << method.name;
  }
}

}  // namespace
}  // namespace tribunal::greedy
