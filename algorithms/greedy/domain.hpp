// Inside and outside of a boundary, as seen from its vertices.
#pragma once

#include "algorithms/greedy/problem.hpp"

#include <vector>

namespace tribunal {

/// What of the plane around each vertex of the boundary belongs to the domain. Without a boundary everything
/// is inside.
class Domain {
 public:
  /// O(b log b) for a boundary of b edges.
  explicit Domain(const GreedyProblem& problem);

  /// Whether the domain lies just counter-clockwise of the direction from `vertex` to `site`. Elsewhere than
  /// at the boundary it lies all around. O(log of the boundary edges at the vertex).
  bool opens_after(Index vertex, Index site) const;

  /// Whether a segment between two sites that conflicts with no edge of the boundary runs inside.
  bool admits(const Edge& segment) const {
    return opens_after(segment[0], segment[1]) && opens_after(segment[1], segment[0]);
  }

 private:
  struct Spoke {
    Index vertex, end;
    bool leads_away;  // the boundary runs from the vertex to the end
  };

  const PlanarProblem& problem_;
  std::vector<Spoke> spokes_;  // by vertex, then counter-clockwise
};

}  // namespace tribunal
