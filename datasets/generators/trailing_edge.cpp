// Points around the trailing edge of the NACA 0012 aerofoil, clustered as for a boundary layer: twelve layers
// along the normals of both sides, from the wall on, each spacing half as large again as the one below, and
// the same on both sides of the wake line. Stations crowd towards the edge. The first spacing is 10^-(3 + s)
// chords for the seeds s = 1, ..., 6; further seeds begin anew.
//
// The four-digit thickness with the last coefficient -.1036, which closes the trailing edge; x = 1 there.
#include "datasets/generators/generators.hpp"

#include <array>
#include <cmath>

namespace tribunal::generators {
namespace {
constexpr int layers = 12;
constexpr double growth = 1.5;

struct Wall {
  double height, slope;
};
Wall upper_wall(double x) {
  const double root = std::sqrt(x);
  const double height = 0.2969 * root + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1036 * x)));
  const double slope = 0.14845 / root + (-0.1260 + x * (-0.7032 + x * (0.8529 - 0.4144 * x)));
  return {0.6 * height, 0.6 * slope};
}

std::array<double, layers> offsets(double spacing) {
  std::array<double, layers> heights{};
  for (std::size_t k = 1; k < layers; ++k, spacing *= growth) heights[k] = heights[k - 1] + spacing;
  return heights;
}

std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  double spacing = 1e-4;
  for (std::uint64_t s = 0; s < (seed + 5) % 6; ++s) spacing /= 10;
  const auto heights = offsets(spacing);
  const std::uint64_t stations = n / (4 * layers - 4) + 1;  // of 47 points each: enough
  std::vector<Point2> points{{{1, 0}}};
  const auto add = [&](double x, double y) {
    if (points.size() < n) points.push_back({{x, y}});
  };
  for (std::uint64_t i = 0; i <= stations; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(stations);
    const double from_edge = 0.2 * part * part;
    const Wall wall = i == 0 ? Wall{0, upper_wall(1).slope} : upper_wall(1 - from_edge);
    const double length = std::sqrt(1 + wall.slope * wall.slope);
    for (std::size_t k = i == 0 ? 1 : 0; k < layers; ++k) {
      const double x = 1 - from_edge - wall.slope / length * heights[k];
      const double y = wall.height + heights[k] / length;
      add(x, y);
      add(x, -y);
      add(1 + from_edge, heights[k]);
      if (k > 0) add(1 + from_edge, -heights[k]);
    }
  }
  return points;
}
}  // namespace

constinit const Dataset trailing_edge{
    .about = {.name = "trailing-edge",
              .cites = "Barth, Figure 3.4.3; Jacobs, Ward, Pinkerton 1933",
              .summary = "layers around an aerofoil's trailing edge, the first 10^-(3 + seed) chords high",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
