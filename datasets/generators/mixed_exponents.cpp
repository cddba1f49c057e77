// Coordinates of random sign, mantissa and exponent, from 2^-100 (8e-31) to 2^100 (1e30): differences swallow
// one coordinate whole, yet the degree-four products of incircle neither overflow nor underflow.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

#include <cmath>

namespace tribunal::generators {
namespace {
double coordinate(Random& random) {
  const double mantissa = 1 + random.unit();
  const int exponent = static_cast<int>(random.below(200)) - 100;
  return std::ldexp((random.bits() & 1) != 0 ? mantissa : -mantissa, exponent);
}

std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  return each(n, [&](std::uint64_t) {
    const double x = coordinate(random);
    const double y = coordinate(random);
    return Point2{{x, y}};
  });
}
}  // namespace

constinit const Dataset mixed_exponents{
    .about = {.name = "mixed-exponents",
              .cites = "this project",
              .summary =
                  "coordinates from 1e-30 to 1e30 side by side: outside the domain of integer backends",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
