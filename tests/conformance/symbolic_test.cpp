// Law: with ties broken by `+sos` there is one triangulation of a point set, the same for every exact
// backend, every algorithm and every order of insertion, grids and circles included; and it is Delaunay.
#include "algorithms/mesh/canonical.hpp"
#include "tests/conformance/run.hpp"

#include <optional>
#include <ostream>

namespace tribunal {
namespace {

std::vector<Point2> grid() {
  std::vector<Point2> points;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y) points.push_back({{double(x), double(y)}});
  return points;
}

/// The grid turned by the angle of (4, 3): every square of it is a circle, too.
std::vector<Point2> tilted_grid() {
  std::vector<Point2> points;
  for (const Point2& p : grid()) points.push_back({{4 * p[0] - 3 * p[1], 4 * p[1] + 3 * p[0]}});
  return points;
}

/// All integer points at that distance from the origin, and the center.
std::vector<Point2> circle(int radius) {
  std::vector<Point2> points{{{0, 0}}};
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      if (x * x + y * y == radius * radius) points.push_back({{double(x), double(y)}});
  return points;
}

std::vector<Point2> concentric_circles() {
  std::vector<Point2> points = circle(65);
  for (const Point2& p : circle(25))
    if (!(p == points[0])) points.push_back(p);
  return points;
}

struct Sites {
  std::string name;
  std::vector<Point2> points;
};
void PrintTo(const Sites& sites, std::ostream* out) { *out << sites.name; }

class Symbolic : public testing::TestWithParam<Sites> {};

TEST_P(Symbolic, EveryBackendAlgorithmAndOrderGivesTheOneTriangulation) {
  const auto& points = GetParam().points;
  std::optional<std::string> reference;
  for (const BackendEntry& backend : symbolic_backends())
    for (const auto& algorithm : planar_algorithms()) {
      if (algorithm.about.promise != Promise::delaunay) continue;
      for (const std::uint64_t seed : {1, 2, 3}) {
        const Order order = seed == 3 ? Order::hilbert : Order::random;
        const Triangulation t = run(points, algorithm, backend.about->name, order, seed);
        ASSERT_EQ(t.outcome, Outcome::ok)
            << backend.about->name << ", " << algorithm.about.name << ": " << t.reason;
        const std::string found = to_hex(digest(t.triangles));
        if (!reference) {
          reference = found;
          EXPECT_TRUE(check(points, t).valid()) << faults_of(check(points, t));
        }
        ASSERT_EQ(found, *reference) << backend.about->name << ", " << algorithm.about.name << ", seed "
                                     << seed;
      }
    }
}

/// The rank is the points' own, so that it does not matter where they stand in the file.
TEST_P(Symbolic, PermutingTheInputPermutesTheTriangulation) {
  const auto& points = GetParam().points;
  std::vector<Point2> reversed(points.rbegin(), points.rend());
  const auto& algorithm = planar_algorithms()[0];
  const Triangulation forward = run(points, algorithm, "filtered+sos"),
                      backward = run(reversed, algorithm, "filtered+sos");
  auto renamed = backward.triangles;
  for (auto& triangle : renamed)
    for (auto& vertex : triangle) vertex = static_cast<Index>(points.size()) - 1 - vertex;
  EXPECT_EQ(digest(renamed), digest(forward.triangles));
}

/// What there is to break: without it the order of insertion decides.
TEST(WithoutTieBreaking, TheOrderShows) {
  const auto& algorithm = planar_algorithms()[0];
  EXPECT_NE(digest(run(grid(), algorithm, "gmp", Order::random, 1).triangles),
            digest(run(grid(), algorithm, "gmp", Order::random, 2).triangles));
}

INSTANTIATE_TEST_SUITE_P(Cospherical, Symbolic,
                         testing::Values(Sites{"grid", grid()}, Sites{"tilted_grid", tilted_grid()},
                                         Sites{"circle_of_36", circle(65)},
                                         Sites{"circle_of_108", circle(1105)},
                                         Sites{"concentric_circles", concentric_circles()}),
                         [](const auto& sites) { return sites.param.name; });

}  // namespace
}  // namespace tribunal
