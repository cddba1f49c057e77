// Independent and uniform on the unit square, on the lattice of pitch 2^-53.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  return each(n, [&](std::uint64_t) {
    const double x = random.unit();
    const double y = random.unit();
    return Point2{{x, y}};
  });
}
}  // namespace

constinit const Dataset uniform{
    .about = {.name = "uniform",
              .cites = "common practice",
              .summary = "independent uniform points of the unit square: the easy case",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
