// What the greedy triangulations are asked, and what all of them answer.
#pragma once

#include "algorithms/algorithm.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

/// Sites, and the edges that go in before any candidate (Barth, section 3.4): those of the boundary, then the
/// constraints, in the order given. Two of them meet in a common end or not at all, and no site lies inside
/// one; otherwise the problem is refused. With a boundary, every site lies in the domain or on its boundary.
struct GreedyProblem {
  const PlanarProblem& planar;
  std::span<const Edge> constraints = {};
  std::span<const Edge> boundary = {};  ///< directed, the domain on the left; none: the convex hull
};

/// The edges of a greedy triangulation in the order of their acceptance, given ones first.
struct GreedyEdges {
  std::vector<Edge> edges;           ///< each with its smaller index first
  std::uint64_t candidates = 0;      ///< taken from the pool
  std::uint64_t conflict_tests = 0;  ///< pairs of segments tried for a crossing
  std::uint64_t search_steps = 0;    ///< nodes of search trees visited
};

}  // namespace tribunal
