// The spiral r = a t with jitter: point i at radius i + 1, about an eighth of a radian on from the one
// before. The angle advances by a rotation of rational sine and cosine, so that no library's sine decides the
// bytes.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

namespace tribunal::generators {
namespace {
constexpr double half_tangent = 1.0 / 16;
constexpr double cosine = (1 - half_tangent * half_tangent) / (1 + half_tangent * half_tangent);
constexpr double sine = 2 * half_tangent / (1 + half_tangent * half_tangent);
constexpr double jitter = 0.25;

std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  Point2 direction{{1, 0}};
  return each(n, [&](std::uint64_t i) {
    const double radius = static_cast<double>(i + 1);
    const double dx = jitter * (2 * random.unit() - 1);
    const double dy = jitter * (2 * random.unit() - 1);
    const Point2 point{{radius * direction[0] + dx, radius * direction[1] + dy}};
    direction = {{cosine * direction[0] - sine * direction[1], sine * direction[0] + cosine * direction[1]}};
    return point;
  });
}
}  // namespace

constinit const Dataset spiral{
    .about = {.name = "spiral",
              .cites = "this project",
              .summary = "jittered spiral, each point outside the hull of those before: bad in input order",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
