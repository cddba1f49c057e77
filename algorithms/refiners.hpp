// The ways to refine a user's boundary, by name.
#pragma once

#include "algorithms/constrained/constrained.hpp"
#include "algorithms/parameter.hpp"
#include "algorithms/refinement/steiner_mesh.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal::refinement {

struct RefinementProblem {
  const Graph& graph;
  std::span<const Index> order;         ///< of insertion of the graph's points
  const Kernel2& kernel;                ///< bound to them
  Settings settings = {};               ///< accepted
  std::span<const double> values = {};  ///< of a field at the graph's points; empty where there is none
};

struct RefinedGraph {
  ConstrainedTriangulation report;  ///< outcome and reason, and what was in the way; no mesh
  Refined mesh;
  std::vector<std::pair<std::string_view, std::uint64_t>> counts;  ///< splits, deleted, ...
};

struct Refiner {
  std::string_view name;
  std::string_view cites;
  std::string_view summary;  ///< one line
  std::span<const Parameter> parameters = {};
  RefinedGraph (*run)(const RefinementProblem&);  ///< failures are outcomes
  bool delaunay =
      true;  ///< whether the mesh is constrained Delaunay; a constrained triangulation it always is
};

/// All there are, in the order in which they are listed to users.
std::span<const Refiner> refiners();

/// The one of that name, or null.
const Refiner* find_refiner(std::string_view name);

}  // namespace tribunal::refinement
