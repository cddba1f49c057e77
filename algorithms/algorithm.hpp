// What a planar algorithm is: a function from sites in an order, over a kernel, to triangles.
#pragma once

#include "algorithms/parameter.hpp"
#include "algorithms/triangulation.hpp"
#include "predicates/kernel.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace tribunal {

/// What the triangles of an algorithm are, and what the exact checker holds them to.
enum class Promise : std::uint8_t {
  triangulation,  ///< of the convex hull
  delaunay,       ///< and no site lies strictly inside a circle
};

/// What `tribunal list algorithms` says of an algorithm.
struct AlgorithmAbout {
  std::string_view name;
  int dimension;
  std::string_view cites;
  std::string_view summary;  ///< one line
  Promise promise = Promise::delaunay;
  /// Of Delaunay algorithms: inserts site by site with strict circle tests, and so makes the same mesh and
  /// the same tau as all others that do. One that does not may decide ties otherwise, and counts no tau.
  bool incremental = true;
  bool reads_values = false;  ///< wants data by point, unless a setting gives them
};

/// What the front door hands to an algorithm: distinct sites in insertion order, the first three not
/// collinear by the kernel's own word and counter-clockwise or clockwise as they come.
struct PlanarProblem {
  std::span<const Point2> points;  ///< as the user gave them
  std::span<const Index> sites;    ///< indices into points, in insertion order
  const Kernel2& kernel;
  Settings settings = {};               ///< of the algorithm's parameters, accepted
  std::span<const double> values = {};  ///< data by point; empty where there are none
};

struct PlanarAlgorithm {
  AlgorithmAbout about;
  std::span<const Parameter> parameters = {};  ///< its variants; the default is the algorithm by that name
  std::string_view order = "random";           ///< the insertion order for users who name none
  /// Triangulates the sites; fills triangles, hull, counters and history. Throws Abandon
  /// (algorithms/abandon.hpp) when the signs make no sense or a budget runs out; the front door turns that
  /// into an outcome.
  Triangulation (*run)(const PlanarProblem&);
};

}  // namespace tribunal
