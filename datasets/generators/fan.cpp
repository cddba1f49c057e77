// Segments that meet in one point, in a box.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/outline.hpp"
#include "datasets/shapes/pslg_points.hpp"

#include <algorithm>

namespace tribunal {
namespace {

DatasetGraph graph(std::uint64_t n, std::uint64_t) {
  const std::uint64_t spokes = std::max<std::uint64_t>(2, n - std::min<std::uint64_t>(n, 5));
  DatasetGraph fan;
  shapes::add_loop(fan, {{{-2, -2}}, {{2, -2}}, {{2, 2}}, {{-2, 2}}});
  fan.points.push_back({{0, 0}});
  for (std::uint64_t i = 0; i < spokes; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(spokes - 1), norm = 1 + t * t;
    fan.segments.push_back({4, static_cast<std::uint32_t>(fan.points.size())});
    fan.points.push_back({{(1 - t * t) / norm, 2 * t / norm}});
  }
  return fan;
}

}  // namespace

constinit const Dataset generators::fan{
    .about = {.name = "fan",
              .cites = "common practice",
              .summary = "segments from one vertex over a quarter of a turn, in a box: ever smaller angles",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n, std::uint64_t seed) { return shapes::first_points(graph(n, seed), n); },
    .graph = graph,
};

}  // namespace tribunal
