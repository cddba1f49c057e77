// Refinement that follows a solution (Barth section 3.5, "Mesh Adaptation").
#pragma once

#include "algorithms/refinement/chew.hpp"
#include "algorithms/refinement/solution.hpp"

namespace tribunal::refinement {

struct AdaptiveOptions {
  ChewOptions chew;
  double tolerance = 0.01;  ///< of SolutionMeasure
};

struct Adapted {
  Refinement refinement;
  double before = 0, after = 0;  ///< the largest measure in the domain
};

/// Circumcentre refinement in which triangles fail by the measure of the field, too. Where the field is
/// bounded by B it ends: edges no longer than tolerance / (2 B) pass.
Adapted refine_by_solution(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                           Field& field, const AdaptiveOptions& options);

}  // namespace tribunal::refinement
