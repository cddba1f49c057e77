// Independent, both coordinates standard normal: dense in the middle, few far out.
#include "datasets/generators/each.hpp"
#include "datasets/generators/gaussian.hpp"
#include "datasets/generators/generators.hpp"

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  return each(n, [&](std::uint64_t) {
    const double x = gaussian(random);
    const double y = gaussian(random);
    return Point2{{x, y}};
  });
}
}  // namespace

constinit const Dataset normal{
    .about = {.name = "normal",
              .cites = "Karney 2016 (sampling)",
              .summary = "independent standard normal coordinates: density varies",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
