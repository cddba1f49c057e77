// Random points of the circle of radius 2^26, each rounded to the nearest integers: less than one unit off.
// Directions come from rejection in the disk, not from sines, whose last bits differ between machines.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

#include <cmath>

namespace tribunal::generators {
namespace {
constexpr double radius = 0x1p26;

Point2 on_circle(Random& random) {
  for (;;) {
    const double x = 2 * random.unit() - 1;
    const double y = 2 * random.unit() - 1;
    const double square = x * x + y * y;
    if (square > 1 || square < 0x1p-20) continue;
    const double scale = radius / std::sqrt(square);
    return {{std::round(x * scale), std::round(y * scale)}};
  }
}

std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  return each(n, [&](std::uint64_t) { return on_circle(random); });
}
}  // namespace

constinit const Dataset near_circle{
    .about = {.name = "near-circle",
              .cites = "common practice",
              .summary =
                  "points of a circle of radius 2^26 rounded to integers: nearly cocircular, large hull",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
