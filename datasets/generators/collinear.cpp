// The points (3i, 2i), i = 0..n-1, in a random order: no triangle at all.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  auto points = each(n, [](std::uint64_t i) {
    const auto step = static_cast<double>(i);
    return Point2{{3 * step, 2 * step}};
  });
  Random(seed).shuffle(std::span(points));
  return points;
}
}  // namespace

constinit const Dataset collinear{
    .about = {.name = "collinear",
              .cites = "this project",
              .summary = "all points exactly on one line: the triangulation is a path",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
