// The ulp grid p + (i, j) 2^-53 around p = (1/2, 1/2), with q = (12, 12) and r = (24, 24) first: the whole
// grid lies within rounding of the line qr, and rounded orientation tests of it contradict each other. The
// source's pictures show 256 x 256 pixels; n = 65,538 gives just these.
#include "datasets/generators/generators.hpp"
#include "datasets/generators/square.hpp"

#include <algorithm>

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  std::vector<Point2> points{{{12, 12}}, {{24, 24}}};
  points.resize(std::min<std::uint64_t>(n, points.size()));
  const auto pixels = square(n - points.size(), [](double column, double row) {
    return Point2{{0.5 + column * 0x1p-53, 0.5 + row * 0x1p-53}};
  });
  points.insert(points.end(), pixels.begin(), pixels.end());
  return points;
}
}  // namespace

constinit const Dataset kettner{
    .about = {.name = "kettner",
              .cites = "Kettner, Mehlhorn, Pion, Schirra, Yap 2008, set 2a",
              .summary = "ulp-spaced grid in line with two far points: rounded signs contradict each other",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
