// Thin slots: pairs of parallel segments a billionth of their length apart, in a box.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/outline.hpp"
#include "datasets/shapes/pslg_points.hpp"

#include <algorithm>

namespace tribunal {
namespace {

DatasetGraph graph(std::uint64_t n, std::uint64_t) {
  const std::uint64_t slots = std::max<std::uint64_t>(1, (n - std::min<std::uint64_t>(n, 4) + 3) / 4);
  const auto top = static_cast<double>(slots);
  DatasetGraph box;
  shapes::add_loop(box, {{{-1, -1}}, {{1, -1}}, {{1, top}}, {{-1, top}}});
  for (std::uint64_t i = 0; i < slots; ++i)
    for (const double y : {static_cast<double>(i), static_cast<double>(i) + 1e-9}) {
      const auto first = static_cast<std::uint32_t>(box.points.size());
      box.points.push_back({{-0.5, y}});
      box.points.push_back({{0.5, y}});
      box.segments.push_back({first, first + 1});
    }
  return box;
}

}  // namespace

constinit const Dataset generators::slot{
    .about = {.name = "slot",
              .cites = "common practice",
              .summary = "pairs of parallel segments 1e-9 apart, in a box",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n, std::uint64_t seed) { return shapes::first_points(graph(n, seed), n); },
    .graph = graph,
};

}  // namespace tribunal
