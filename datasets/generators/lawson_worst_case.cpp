// Two facing convex chains of m points each, m even: from the right start, edge swapping needs on the order
// of m^2 flips and no edge returns (Barth 3.3d). The upper chain is x_i = 2i - (m-1), y_i = 1 + x_i^2 / (100
// (m-1)^2); the lower one is its mirror image. Both are scaled by S = 200000 (m-1)^2 to integers, then the
// lower one is moved right by one unit to break the ties between a point and its image. The upper chain comes
// first, then the lower one.
//
// Given n, 2m is the largest multiple of 4 that is at most n (n < 4: the first n points of m = 2). The
// coordinates are exact while S (m-1) <= 2^53, which holds up to m = 3558; larger n give 7,116 points.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"

#include <algorithm>

namespace tribunal::generators {
namespace {
constexpr std::uint64_t longest = 3558;

std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  const std::uint64_t m = std::clamp<std::uint64_t>(n / 4 * 2, 2, longest);
  const double last = static_cast<double>(m - 1);
  const double scale = 200000 * last * last;
  return each(std::min(n, 2 * m), [&](std::uint64_t i) {
    const double x = 2 * static_cast<double>(i % m) - last;
    const double y = scale + 2000 * x * x;
    return i < m ? Point2{{scale * x, y}} : Point2{{scale * x + 1, -y}};
  });
}
}  // namespace

constinit const Dataset lawson_worst_case{
    .about = {.name = "lawson-worst-case",
              .cites = "Barth 3.3d",
              .summary =
                  "two facing chains, multiple of 4 and at most 7,116 points: quadratically many flips",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
