#include "datasets/dataset.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tribunal {
namespace {

struct Box {
  Point2 low, high;
  double side() const { return std::max(high[0] - low[0], high[1] - low[1]); }
};

Box bounding_box(std::span<const Point2> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{{infinity, infinity}}, {{-infinity, -infinity}}};
  for (const Point2& point : points) {
    for (const std::size_t axis : {0, 1}) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  }
  return box;
}

/// Every coordinate halved; inexact only where the result is subnormal.
std::vector<Point2> halved(std::span<const Point2> points) {
  std::vector<Point2> half(points.begin(), points.end());
  for (Point2& point : half)
    for (double& coordinate : point.coordinate) coordinate /= 2;
  return half;
}

/// The nearest integer, halves upwards; 0 <= x < 2^63. The library's own is a call for each number on
/// machines without an instruction for it.
double rounded(double x) {
  const double whole = static_cast<double>(static_cast<std::int64_t>(x));
  return x - whole < 0.5 ? whole : whole + 1;
}

}  // namespace

std::vector<Point2> quantise(std::span<const Point2> points, int bits) {
  assert(1 <= bits && bits <= 53);
  if (points.empty()) return {};
  const Box box = bounding_box(points);
  const double side = box.side();
  // A side beyond the range of doubles: then half of each coordinate loses only what is far below the
  // lattice.
  if (std::isinf(side)) return quantise(halved(points), bits);
  if (side == 0) return std::vector<Point2>(points.size(), Point2{{0, 0}});

  // The side is first brought to [1, 2) by a power of two, which is exact: so neither tiny nor huge boxes
  // overflow the scale, and a box whose side is the lattice's keeps its points, the scale being a power of
  // two itself.
  const double power = std::ldexp(1.0, std::ilogb(side));
  const double last = std::ldexp(1.0, bits) - 1;
  const double scale = last / (side / power);
  std::vector<Point2> lattice(points.begin(), points.end());
  for (Point2& point : lattice) {
    for (const std::size_t axis : {0, 1}) {
      const double offset = point[axis] - box.low[axis];
      const double scaled = rounded(offset / power * scale);
      // At 52 bits and more the rounded product can miss the far side by one.
      point[axis] = offset == side ? last : std::min(scaled, last);
    }
  }
  return lattice;
}

DatasetGraph quantise(DatasetGraph graph, int bits) {
  const auto size = static_cast<std::ptrdiff_t>(graph.points.size());
  graph.points.insert(graph.points.end(), graph.holes.begin(), graph.holes.end());
  graph.points = quantise(graph.points, bits);
  graph.holes.assign(graph.points.begin() + size, graph.points.end());
  graph.points.resize(static_cast<std::size_t>(size));
  std::erase_if(graph.segments, [&](const auto& s) { return graph.points[s[0]] == graph.points[s[1]]; });
  return graph;
}

}  // namespace tribunal
