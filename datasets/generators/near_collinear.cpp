// Points of the line y = sqrt(2) x, 1 <= x < 2, rounded, then moved up or down by at most two ulps.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

#include <cmath>

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  const double slope = std::sqrt(2.0);
  return each(n, [&](std::uint64_t) {
    const double x = 1 + random.unit();
    double y = slope * x;
    const std::uint64_t noise = random.below(5);
    for (std::uint64_t step = noise; step < 2; ++step) y = std::nextafter(y, 0.0);
    for (std::uint64_t step = noise; step > 2; --step) y = std::nextafter(y, 4.0);
    return Point2{{x, y}};
  });
}
}  // namespace

constinit const Dataset near_collinear{
    .about = {.name = "near-collinear",
              .cites = "this project",
              .summary = "points of a line of slope sqrt 2, off it by a few ulps: every orientation is close",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
