// A comb: teeth a tenth of their distance apart.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/outline.hpp"
#include "datasets/shapes/pslg_points.hpp"

#include <algorithm>

namespace tribunal {
namespace {

DatasetGraph graph(std::uint64_t n, std::uint64_t) {
  const std::uint64_t teeth = std::max<std::uint64_t>(2, (n + 1) / 4);
  shapes::Outline outline{{{0, -1}}, {{static_cast<double>(teeth), -1}}};
  for (std::uint64_t i = teeth; i-- > 0;) {
    const auto x = static_cast<double>(i);
    for (const Point2 p : {Point2{{x + 1, 0}}, Point2{{x + 0.9, 0}}, Point2{{x + 0.9, 1}}, Point2{{x, 1}}})
      outline.push_back(p);
  }
  DatasetGraph comb;
  shapes::add_loop(comb, outline);
  return comb;
}

}  // namespace

constinit const Dataset generators::comb{
    .about = {.name = "comb",
              .cites = "common practice",
              .summary = "a comb with teeth nine times as wide as the gaps between them",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n, std::uint64_t seed) { return shapes::first_points(graph(n, seed), n); },
    .graph = graph,
};

}  // namespace tribunal
