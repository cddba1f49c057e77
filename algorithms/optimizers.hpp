// What makes a given triangulation better: the criteria that users choose among.
#pragma once

#include "algorithms/flips/sites.hpp"
#include "algorithms/parameter.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal {

/// A triangulation of the sites' convex hull, counter-clockwise.
struct MeshProblem {
  Sites sites;
  std::span<const Triangle> triangles;
  std::span<const double> values;  ///< data by point; empty where there are none
  Settings settings = {};          ///< accepted
};

struct OptimizedMesh {
  std::vector<Triangle> triangles;
  std::vector<std::pair<std::string_view, std::uint64_t>> counts;  ///< flips, tests, ...
};

struct MeshOptimizer {
  std::string_view name;
  std::string_view cites;
  std::string_view summary;  ///< one line
  bool reads_values = false;
  std::span<const Parameter> parameters = {};
  OptimizedMesh (*run)(const MeshProblem&);  ///< throws Abandon
};

/// All there are, in the order in which they are listed to users.
std::span<const MeshOptimizer> mesh_optimizers();

/// The one of that name, or null.
const MeshOptimizer* find_mesh_optimizer(std::string_view name);

}  // namespace tribunal
