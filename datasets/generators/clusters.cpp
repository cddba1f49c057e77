// Ten normal clusters of deviation 1/100, centres uniform in the unit square, members drawn in turn.
#include "datasets/generators/each.hpp"
#include "datasets/generators/gaussian.hpp"
#include "datasets/generators/generators.hpp"

#include <array>

namespace tribunal::generators {
namespace {
constexpr double deviation = 0.01;

std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  std::array<Point2, 10> centres{};
  for (auto& centre : centres)
    for (auto& coordinate : centre.coordinate) coordinate = random.unit();
  return each(n, [&](std::uint64_t i) {
    const Point2& centre = centres[i % centres.size()];
    const double x = centre[0] + deviation * gaussian(random);
    const double y = centre[1] + deviation * gaussian(random);
    return Point2{{x, y}};
  });
}
}  // namespace

constinit const Dataset clusters{
    .about = {.name = "clusters",
              .cites = "common practice",
              .summary = "10 normal clusters in the unit square: long thin triangles between dense places",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
