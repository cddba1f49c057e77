// What is raced over.
#pragma once

#include "algorithms/triangulation.hpp"
#include "datasets/dataset.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

enum class RaceKind : std::uint8_t {
  triangulation,  ///< points to a triangulation of their hull
  graph,          ///< points and segments to the constrained Delaunay triangulation of the hull
  refinement,     ///< a domain to a constrained Delaunay mesh within bounds, with new vertices
};

inline constexpr std::array<std::string_view, 3> race_kind_names{"triangulation", "graph", "refinement"};

constexpr std::string_view to_string(RaceKind kind) {
  return race_kind_names[static_cast<std::size_t>(kind)];
}

/// What refined triangles are to be like.
struct Bounds {
  double sine_squared = 0;  ///< of the smallest angle, at least
  double longest_edge = std::numeric_limits<double>::infinity();

  double degrees() const;  ///< the angle
  bool operator==(const Bounds&) const = default;
};

struct Course {
  std::string dataset;
  std::uint64_t n = 0;  ///< as asked for; 0: all there are, of a dataset of fixed size
  RaceKind kind = RaceKind::triangulation;
  Bounds bounds = {};  ///< of refinement

  bool operator==(const Course&) const = default;
};

/// "uniform", "counties, segments", "gulf, 20.7 degrees, edges to 55".
std::string describe(const Course& course);

/// What every contestant is given.
struct Ground {
  std::vector<Point2> points;  ///< distinct where there are no segments
  std::vector<Edge> segments = {};
  std::vector<Point2> holes = {};
  Bounds bounds = {};
};

/// Whether there are such courses over a dataset: with segments, or with an inside.
bool offers(const Dataset& dataset, RaceKind kind);

/// The course must be one that the dataset offers. Segments that cross are split beforehand. Throws Abandon
/// where that does not settle.
Ground ground_of(const Course& course, std::uint64_t seed);

}  // namespace tribunal::bench
