// Barth's outline of the greedy triangulation (section 3.4): every pair of sites is a candidate.
#pragma once

#include "algorithms/greedy/problem.hpp"

namespace tribunal {

/// The edges that are in T, and Step 5's question about them. An edge that is inserted has passed.
class AcceptedEdges {
 public:
  AcceptedEdges() = default;
  AcceptedEdges(const AcceptedEdges&) = delete;
  AcceptedEdges& operator=(const AcceptedEdges&) = delete;
  virtual ~AcceptedEdges() = default;

  /// Whether the segment meets an edge of T in more than a common end. Sites inside it need no attention: up
  /// to the first of them it was a candidate before, and what conflicted with that, or it itself, is in T.
  virtual bool conflicts(const Edge& segment) = 0;
  virtual void insert(const Edge& segment) = 0;
};

/// Steps 1 to 6 with the given T, which is empty. Takes the pairs of sites from the shortest on until Euler's
/// formula is satisfied: n sites, b of them on the boundary of the hull, collinear ones included, have 3n - 3
/// - b edges. With a boundary of its own every pair is tried. Fills edges and candidates.
///
/// O(n^2 log n) without Step 5, 8 n^2 bytes. Abandons where the pairs run out before that (wrong signs), a
/// given edge conflicts, or there are more sites than `most_pooled_sites`.
GreedyEdges triangulate_from_pool(const GreedyProblem& problem, AcceptedEdges& accepted);

inline constexpr std::size_t most_pooled_sites = 1 << 15;

/// Abandons (refused_input) where there are more sites than that.
void require_pool(const PlanarProblem& problem);

/// How many sites are on the boundary of the convex hull, collinear ones included. O(n log n).
std::size_t hull_size(const PlanarProblem& problem);

}  // namespace tribunal
