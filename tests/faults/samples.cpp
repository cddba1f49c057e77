#include "tests/faults/samples.hpp"

#include "algorithms/verify/verify.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tribunal::faults {
namespace {

using Points = std::vector<LatticePoint>;

/// All sites on the circle of the counter-clockwise a, b, c, if none is inside; empty otherwise. In the order
/// of `sites`.
std::vector<std::uint32_t> on_empty_circle(const Points& points, const std::vector<std::uint32_t>& sites,
                                           const Triangle& t) {
  std::vector<std::uint32_t> on;
  for (const std::uint32_t site : sites) {
    const bool corner = std::find(t.begin(), t.end(), site) != t.end();
    const Wide side = corner ? Wide{0} : in_circle(points[t[0]], points[t[1]], points[t[2]], points[site]);
    if (side > 0) return {};
    if (side == 0) on.push_back(site);
  }
  return on;
}

/// Cuts ears off a convex polygon at random.
void cut_ears(std::vector<std::uint32_t> polygon, Random& random, std::vector<Triangle>& triangles) {
  while (polygon.size() >= 3) {
    const std::size_t n = polygon.size(), i = random.below(n);
    triangles.push_back({polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::int64_t draw(Random& random, std::int64_t bound) {
  return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(bound)));
}

Points random_points(Random& random, std::uint64_t n, std::int64_t width) {
  Points points;
  for (std::uint64_t i = 0; i < n; ++i) points.push_back({draw(random, width), draw(random, width)});
  return points;
}

Points grid(std::int64_t columns, std::int64_t rows) {
  Points points;
  for (std::int64_t x = 0; x < columns; ++x)
    for (std::int64_t y = 0; y < rows; ++y) points.push_back({x, y});
  return points;
}

Points part_of_grid(Random& random) {
  Points points = grid(8, 7);
  random.shuffle(std::span(points));
  points.resize(12 + random.below(24));
  return points;
}

/// Some of the 36 lattice points on the circle of radius 65, and a few inside.
Points cocircular_points(Random& random) {
  Points points;
  for (std::int64_t x = -65; x <= 65; ++x)
    for (std::int64_t y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65) points.push_back({x, y});
  random.shuffle(std::span(points));
  points.resize(8 + random.below(16));
  for (std::uint64_t i = random.below(8); i > 0; --i)
    points.push_back({draw(random, 61) - 30, draw(random, 61) - 30});
  return points;
}

/// Many points on the sides of a square, some inside.
Points collinear_on_hull(Random& random) {
  constexpr std::int64_t side = 1000;
  Points points{{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (int i = 0; i < 12; ++i) {
    const std::int64_t t = 1 + draw(random, side - 1);
    const std::array<LatticePoint, 4> on{{{t, 0}, {side, t}, {t, side}, {0, t}}};
    points.push_back(on[static_cast<std::size_t>(i % 4)]);
  }
  for (std::uint64_t i = 4 + random.below(14); i > 0; --i)
    points.push_back({1 + draw(random, side - 1), 1 + draw(random, side - 1)});
  return points;
}

Points clusters(Random& random) {
  Points points;
  for (int c = 0; c < 4; ++c) {
    const LatticePoint centre{draw(random, 1 << 17), draw(random, 1 << 17)};
    for (int i = 0; i < 8; ++i) points.push_back({centre.x + draw(random, 16), centre.y + draw(random, 16)});
  }
  return points;
}

Points with_copies(Random& random) {
  Points points = random_points(random, 10 + random.below(15), 200);
  for (std::size_t i = points.size() / 2; i > 0; --i) {
    const LatticePoint copied = points[random.below(points.size())];
    points.push_back(copied);
  }
  random.shuffle(std::span(points));
  return points;
}

}  // namespace

std::vector<std::uint32_t> distinct_sites(const Points& points) {
  std::set<LatticePoint> seen;
  std::vector<std::uint32_t> sites;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (seen.insert(points[i]).second) sites.push_back(i);
  return sites;
}

std::vector<Triangle> triangulate_by_definition(const Points& points, const std::vector<std::uint32_t>& sites,
                                                Random& random) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (std::size_t j = i + 1; j < sites.size(); ++j)
      for (std::size_t k = j + 1; k < sites.size(); ++k) {
        Triangle t{sites[i], sites[j], sites[k]};
        const Wide turn = area(points[t[0]], points[t[1]], points[t[2]]);
        if (turn == 0) continue;
        if (turn < 0) std::swap(t[1], t[2]);
        std::vector<std::uint32_t> circle = on_empty_circle(points, sites, t);
        // Each circle once, by the first three of its points.
        if (circle.size() < 3 || circle[0] != sites[i] || circle[1] != sites[j] || circle[2] != sites[k])
          continue;
        std::sort(circle.begin() + 1, circle.end(), [&](std::uint32_t a, std::uint32_t b) {
          return area(points[circle[0]], points[a], points[b]) > 0;
        });
        cut_ears(circle, random, triangles);
      }
  random.shuffle(std::span(triangles));
  return triangles;
}

std::vector<Triangle> neighbours_of(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> triangle_left_of;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) triangle_left_of[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
  std::vector<Triangle> neighbours(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto across = triangle_left_of.find({triangles[t][(i + 2) % 3], triangles[t][(i + 1) % 3]});
      neighbours[t][i] = across == triangle_left_of.end() ? verify::no_neighbour : across->second;
    }
  return neighbours;
}

Sample make_sample(std::uint32_t i) {
  Random random(0xFA017 + i);
  Sample sample;
  switch (i % families) {
    case 0:
      sample = {"random", random_points(random, 8 + random.below(32), 1 << 17), {}};
      break;
    case 1:
      sample = {"part of a grid", part_of_grid(random), {}};
      break;
    case 2:
      sample = {"grid", grid(2 + draw(random, 5), 2 + draw(random, 5)), {}};
      break;
    case 3:
      sample = {"cocircular", cocircular_points(random), {}};
      break;
    case 4:
      sample = {"collinear on the hull", collinear_on_hull(random), {}};
      break;
    case 5:
      sample = {"clusters", clusters(random), {}};
      break;
    default:
      sample = {"with copies", with_copies(random), {}};
      break;
  }
  sample.triangles = triangulate_by_definition(sample.points, distinct_sites(sample.points), random);
  return sample;
}

std::vector<Sample> make_samples(std::uint32_t count) {
  std::vector<Sample> samples;
  for (std::uint32_t i = 0; i < count; ++i) samples.push_back(make_sample(i));
  return samples;
}

}  // namespace tribunal::faults
