// A triangle with an angle of one degree: what no refinement can enlarge.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/outline.hpp"
#include "datasets/shapes/pslg_points.hpp"

#include <algorithm>

namespace tribunal {
namespace {

DatasetGraph graph(std::uint64_t n, std::uint64_t) {
  constexpr double tangent = 0.017455064928217585;  // of one degree
  const std::uint64_t parts = std::max<std::uint64_t>(1, (n + 2) / 3);
  const std::array<Point2, 3> corners{{{{0, 0}}, {{1, 0}}, {{1, tangent}}}};
  shapes::Outline outline;
  for (std::size_t side = 0; side < 3; ++side) {
    const Point2 from = corners[side], to = corners[(side + 1) % 3];
    for (std::uint64_t i = 0; i < parts; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(parts);
      outline.push_back({{from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}});
    }
  }
  DatasetGraph wedge;
  shapes::add_loop(wedge, outline);
  return wedge;
}

}  // namespace

constinit const Dataset generators::wedge{
    .about = {.name = "wedge",
              .cites = "Shewchuk 1997",
              .summary = "a triangle with an angle of one degree, its sides subdivided",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n, std::uint64_t seed) { return shapes::first_points(graph(n, seed), n); },
    .graph = graph,
};

}  // namespace tribunal
