// A constrained Delaunay triangulation in which edges are locked one after the other.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/edge_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

/// Locked edges never flip; across all others no site that can be seen lies strictly inside a circle.
class ConstrainedMesh {
 public:
  /// From a Delaunay triangulation of the problem's sites. O(n log n).
  ConstrainedMesh(const PlanarProblem& problem, std::span<const Triangle> delaunay)
      : problem_(problem), mesh_(delaunay), locked_(mesh_.edges(), 0), in_region_(mesh_.edges(), 0) {}

  const EdgeMesh& mesh() const { return mesh_; }

  /// An edge of a constrained Delaunay triangulation may be locked: it stays one.
  void lock(Index edge) { locked_[edge] = 1; }
  bool is_locked(Index edge) const { return locked_[edge] != 0; }

  void flip(Index edge) {
    mesh_.flip(edge);
    ++flips_;
  }

  /// Flips edges of the region until none of them is illegal (Lawson 1977). Where the region is what a new
  /// locked edge has crossed, and the mesh was constrained Delaunay before, it is so again: the edges around
  /// the region have stayed legal, for what can be seen across them has become less. O(k^2) for k edges, each
  /// given once.
  void restore(std::span<const Index> region);

  /// Makes each segment an edge, by flipping what it crosses (Sloan 1993), and returns these edges, locked.
  /// O(n + k^2) for k crossings of a segment. Abandons (refused_input) where a segment meets a site or a
  /// locked edge.
  std::vector<Index> force(std::span<const Edge> segments);

  std::uint64_t flips() const { return flips_; }
  std::uint64_t circle_tests() const { return circle_tests_; }

 private:
  bool is_illegal(Index edge);

  const PlanarProblem& problem_;
  EdgeMesh mesh_;
  std::vector<char> locked_, in_region_;  // by edge
  std::uint64_t flips_ = 0, circle_tests_ = 0;
};

}  // namespace tribunal
