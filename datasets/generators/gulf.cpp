// The Gulf of Mexico off Texas, Louisiana and Florida: the coast of the dataset `coast`, closed through the
// sea, with its islands as holes. One step in x is about 3.7 steps in y on the ground; here it counts 4, so
// that shapes are nearly those of the map and coordinates stay integers.
#include "datasets/data/embedded.hpp"
#include "datasets/dataset.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/real.hpp"
#include "datasets/shapes/outline.hpp"

#include <algorithm>

namespace tribunal {
namespace {

/// Follows segments from one point to the next, each once.
class Chains {
 public:
  explicit Chains(std::vector<Point2> points)
      : points_(std::move(points)), next_(points_.size()), used_(points_.size(), false) {
    for (const auto& [a, b] : coast_segments()) {
      next_[a].push_back(b);
      next_[b].push_back(a);
    }
  }
  /// The points from `start` on, until one comes again or there is none.
  shapes::Outline from(std::size_t start) {
    shapes::Outline chain;
    for (std::size_t at = start; !used_[at];) {
      used_[at] = true;
      chain.push_back({{4 * points_[at][0], points_[at][1]}});
      for (const std::size_t neighbour : next_[at])
        if (!used_[neighbour]) {
          at = neighbour;
          break;
        }
    }
    return chain;
  }
  bool is_end(std::size_t point) const { return next_[point].size() == 1; }
  std::size_t size() const { return points_.size(); }

 private:
  std::vector<Point2> points_;
  std::vector<std::vector<std::size_t>> next_;
  std::vector<bool> used_;
};

/// Strictly inside a counter-clockwise or clockwise simple polygon of integers: beside the middle of the
/// lowest vertex's neighbourhood.
Point2 inside(const shapes::Outline& ring) {
  const auto lowest = static_cast<std::size_t>(
      std::min_element(ring.begin(), ring.end(),
                       [](Point2 a, Point2 b) { return a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]); }) -
      ring.begin());
  const Point2 p = ring[lowest], q = ring[(lowest + 1) % ring.size()],
               r = ring[(lowest + ring.size() - 1) % ring.size()];
  constexpr double little = 0x1p-10;  // of steps between lattice points: no vertex lies that close
  return {{p[0] + little * ((q[0] - p[0]) + (r[0] - p[0])) / 2,
           p[1] + little * ((q[1] - p[1]) + (r[1] - p[1])) / 2}};
}

DatasetGraph graph(std::uint64_t, std::uint64_t) {
  Chains chains(find_dataset("coast")->generate(850, 1));
  DatasetGraph gulf;
  std::vector<shapes::Outline> open, islands;
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (chains.is_end(i)) open.push_back(chains.from(i));
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (shapes::Outline ring = chains.from(i); !ring.empty()) islands.push_back(std::move(ring));
  const auto longer = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  shapes::Outline shore = *std::max_element(open.begin(), open.end(), longer);
  if (shore.front() < shore.back()) std::reverse(shore.begin(), shore.end());
  // From Florida's end of the shore through the sea to the Rio Grande's, counter-clockwise around the sea.
  std::reverse(shore.begin(), shore.end());
  const double east = 4 * 4900;
  for (const Point2 p : {Point2{{east, 700}}, Point2{{east, -500}}, Point2{{0, -500}}}) shore.push_back(p);
  shapes::add_loop(gulf, shore);
  for (const shapes::Outline& island : islands) {
    shapes::add_loop(gulf, island);
    gulf.holes.push_back(inside(island));
  }
  return gulf;
}

}  // namespace

constinit const Dataset generators::gulf{
    .about = {.name = "gulf",
              .cites = "U.S. Census Bureau 2017, through us-atlas 3.0.1",
              .summary = "the Gulf of Mexico as a domain: a real coast, the sea before it, islands as holes",
              .fixed_size = 820,
              .integer = true},
    .generate =
        [](std::uint64_t n, std::uint64_t seed) {
          DatasetGraph domain = graph(n, seed);
          domain.points.resize(std::min<std::size_t>(n, domain.points.size()));
          return domain.points;
        },
    .graph = graph,
};

}  // namespace tribunal
