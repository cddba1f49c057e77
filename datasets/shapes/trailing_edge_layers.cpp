#include "datasets/shapes/trailing_edge_layers.hpp"

#include "datasets/shapes/outline.hpp"

#include <array>
#include <cmath>

namespace tribunal::shapes {
namespace {
constexpr std::uint32_t layers = 12;
constexpr double growth = 1.5;

std::array<double, layers> offsets(double spacing) {
  std::array<double, layers> heights{};
  for (std::size_t k = 1; k < layers; ++k, spacing *= growth) heights[k] = heights[k - 1] + spacing;
  return heights;
}

constexpr FourDigit section(bool blunt) {
  return {.camber = 0, .camber_at = 0.5, .thickness = 0.12, .blunt = blunt};
}

/// Points of a station: the first one, at the edge itself, has no points of the wake line, and of a sharp
/// edge none on the wall.
constexpr std::uint32_t first_station(bool blunt) { return (blunt ? 2 : 0) + 4 * (layers - 1); }
constexpr std::uint32_t station_size = 4 * layers - 1;

/// The points of a station in a row: each layer's on the upper and lower wall, then on both sides of the
/// wake.
void add_station(std::vector<Point2>& points, const FourDigit& aerofoil, double from_edge,
                 const std::array<double, layers>& heights) {
  const bool at_edge = from_edge == 0;
  HalfThickness wall = half_thickness(aerofoil, 1 - from_edge);
  const double base = aerofoil.blunt ? half_thickness(aerofoil, 1).height : 0;
  if (at_edge) wall.height = base;
  const double length = std::sqrt(1 + wall.slope * wall.slope);
  for (std::size_t k = at_edge && !aerofoil.blunt ? 1 : 0; k < layers; ++k) {
    const double x = 1 - from_edge - wall.slope / length * heights[k];
    const double y = wall.height + heights[k] / length;
    points.push_back({{x, y}});
    points.push_back({{x, -y}});
    if (at_edge && k == 0) continue;
    const double wake = k == 0 ? 0 : base + heights[k];
    points.push_back({{1 + from_edge, wake}});
    if (k > 0) points.push_back({{1 + from_edge, -wake}});
  }
}

}  // namespace

std::vector<Point2> trailing_edge_layers(std::uint64_t n, std::uint64_t seed, bool blunt) {
  double spacing = 1e-4;
  for (std::uint64_t s = 0; s < (seed + 5) % 6; ++s) spacing /= 10;
  const auto heights = offsets(spacing);
  const std::uint64_t stations = n / (4 * layers - 4) + 1;  // of 47 points each: enough
  std::vector<Point2> points{{{1, 0}}};
  for (std::uint64_t i = 0; i <= stations && points.size() < n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(stations);
    add_station(points, section(blunt), 0.2 * part * part, heights);
  }
  points.resize(n);
  return points;
}

DatasetGraph trailing_edge_graph(std::uint64_t n, std::uint64_t seed, bool blunt) {
  const std::uint32_t before = 1 + first_station(blunt);
  const auto stations = static_cast<std::uint32_t>(n < before ? 0 : (n - before) / station_size);
  DatasetGraph graph{trailing_edge_layers(std::max(n, std::uint64_t{before}), seed, blunt), {}, {}};
  graph.points.resize(before + std::size_t{stations} * station_size);

  // The outline: the upper wall from the edge forwards, the nose, the lower wall back to the edge.
  std::vector<std::uint32_t> loop{0};
  if (blunt) loop.push_back(1);
  for (std::uint32_t i = 0; i < stations; ++i) loop.push_back(before + i * station_size);
  const double front = stations == 0 ? 1 : graph.points[loop.back()][0];
  constexpr std::uint64_t nose_stations = 32;
  for (const Point2& p : outline_of(section(blunt), nose_stations)) {
    if (p[0] > 0.95 * front) continue;
    loop.push_back(static_cast<std::uint32_t>(graph.points.size()));
    graph.points.push_back(p);
  }
  for (std::uint32_t i = stations; i > 0; --i) loop.push_back(before + (i - 1) * station_size + 1);
  if (blunt) loop.push_back(2);
  for (std::size_t i = 0; i < loop.size(); ++i)
    graph.segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  add_loop(graph, box_around(1.5, 8));
  graph.holes.push_back({{0.5, 0}});
  return graph;
}

}  // namespace tribunal::shapes
