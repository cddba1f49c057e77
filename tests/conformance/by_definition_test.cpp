// On tie-free input the Delaunay triangulation is a set that can be written down from its definition: all
// triples whose open disk is empty. Every algorithm returns exactly that set.
#include "algorithms/mesh/canonical.hpp"
#include "datasets/random.hpp"
#include "tests/conformance/run.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace tribunal {
namespace {

using Site = std::array<std::int64_t, 2>;

/// Twice the area of abc. Coordinates below 2^12: everything here fits 64 bits.
std::int64_t area(const Site& a, const Site& b, const Site& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Positive inside the circle of abc: |d|^2 compared with the plane through the lifted a, b, c, at the place
/// of d.
std::int64_t depth(const Site& a, const Site& b, const Site& c, const Site& d) {
  const auto lift = [&](const Site& p) {
    return (p[0] - d[0]) * (p[0] - d[0]) + (p[1] - d[1]) * (p[1] - d[1]);
  };
  return lift(a) * area(d, b, c) + lift(b) * area(d, c, a) + lift(c) * area(d, a, b);
}

/// The triangulation by definition, or nothing where three sites are collinear or four cocircular on an empty
/// disk.
std::optional<std::vector<Triangle>> by_definition(const std::vector<Site>& sites) {
  std::vector<Triangle> triangles;
  const auto n = static_cast<Index>(sites.size());
  for (Index a = 0; a < n; ++a)
    for (Index b = a + 1; b < n; ++b)
      for (Index c = b + 1; c < n; ++c) {
        const std::int64_t turn = area(sites[a], sites[b], sites[c]);
        if (turn == 0) return std::nullopt;
        bool empty = true, tie = false;
        for (Index d = 0; d < n && empty; ++d) {
          if (d == a || d == b || d == c) continue;
          const std::int64_t inside = depth(sites[a], sites[b], sites[c], sites[d]) * (turn > 0 ? 1 : -1);
          empty = inside <= 0;
          tie = tie || inside == 0;
        }
        if (!empty) continue;
        if (tie) return std::nullopt;
        triangles.push_back(turn > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
      }
  return triangles;
}

TEST(ByDefinition, EveryAlgorithmReturnsTheEmptyDisks) {
  int tie_free = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const std::size_t n = 4 + random.below(28);
    const std::uint64_t side = seed % 3 == 0 ? 64 : 4096;
    std::vector<Site> sites(n);
    std::vector<Point2> points(n);
    for (std::size_t i = 0; i < n; ++i) {
      sites[i] = {static_cast<std::int64_t>(random.below(side)),
                  static_cast<std::int64_t>(random.below(side))};
      points[i] = {static_cast<double>(sites[i][0]), static_cast<double>(sites[i][1])};
    }
    const auto expected = by_definition(sites);
    if (!expected) continue;
    ++tie_free;
    for (const auto& algorithm : planar_algorithms()) {
      if (algorithm.about.promise != Promise::delaunay) continue;
      for (const char* backend : {"knuth", "fortune-van-wyk", "filtered", "gmp"}) {
        const Triangulation t = run(points, algorithm, backend, Order::random, seed);
        EXPECT_EQ(canonical(t.triangles), canonical(*expected))
            << algorithm.about.name << " " << backend << " seed " << seed;
      }
    }
  }
  EXPECT_GT(tie_free, 30);
}

}  // namespace
}  // namespace tribunal
