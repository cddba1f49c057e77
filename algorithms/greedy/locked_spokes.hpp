// The rings of locked half-edges around each vertex.
#pragma once

#include "algorithms/mesh/edge_mesh.hpp"

#include <vector>

namespace tribunal {

/// Which locked half-edge follows which around the vertex where both start, whatever unlocked ones lie
/// between them.
class LockedSpokes {
 public:
  explicit LockedSpokes(const EdgeMesh& mesh)
      : mesh_(mesh),
        following_(2 * std::size_t{mesh.edges()}, PlanarMesh::none),
        preceding_(2 * std::size_t{mesh.edges()}, PlanarMesh::none) {}

  bool contains(HalfEdge h) const { return following_[h] != PlanarMesh::none; }

  /// Counter-clockwise; h itself where it is alone.
  HalfEdge following(HalfEdge h) const { return following_[h]; }
  HalfEdge preceding(HalfEdge h) const { return preceding_[h]; }

  /// Enters h into its vertex's ring. Its neighbours are sought both ways at once, so that locking k spokes
  /// of a vertex one after the other takes O(k log k) steps.
  void insert(HalfEdge h) {
    HalfEdge after = h, before = h;
    do {
      after = mesh_.next_counter_clockwise(after);
      before = mesh_.next_clockwise(before);
    } while (after != h && !contains(after) && !contains(before));
    if (after == h) {
      before = h;
    } else if (contains(after)) {
      before = preceding_[after];
    } else {
      after = following_[before];
    }
    link(before, h);
    link(h, after);
  }

 private:
  void link(HalfEdge before, HalfEdge after) {
    following_[before] = after;
    preceding_[after] = before;
  }

  const EdgeMesh& mesh_;
  std::vector<HalfEdge> following_, preceding_;
};

}  // namespace tribunal
