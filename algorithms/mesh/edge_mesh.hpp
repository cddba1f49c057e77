// A triangulation whose edges keep their names while their neighbours flip: topology only.
#pragma once

#include "algorithms/mesh/planar_mesh.hpp"

#include <span>
#include <vector>

namespace tribunal {

/// Half-edges 2e and 2e + 1 are edge e in its two directions; each bounds the face on its left, a triangle or
/// the outer face. A flip moves one edge and renames none, so that a queue may hold edges and a lock on one
/// is a flag. (In a PlanarMesh a half-edge is a place in a triangle, and flips move edges between places.)
class EdgeMesh {
 public:
  /// From the counter-clockwise triangles of a triangulation whose outer boundary is one simple cycle. O(m
  /// log m). Abandons (inconsistent_predicate) where the triangles do not fit together so.
  explicit EdgeMesh(std::span<const Triangle> triangles);

  Index edges() const { return static_cast<Index>(from_.size() / 2); }

  Index from(HalfEdge h) const { return from_[h]; }
  Index to(HalfEdge h) const { return from_[twin(h)]; }
  static constexpr HalfEdge twin(HalfEdge h) { return h ^ 1; }
  static constexpr Index edge_of(HalfEdge h) { return h / 2; }

  /// Around the face on the left.
  HalfEdge next(HalfEdge h) const { return next_[h]; }
  HalfEdge prev(HalfEdge h) const { return prev_[h]; }
  bool is_outer(HalfEdge h) const { return outer_[h]; }
  bool is_inner(Index edge) const { return !outer_[2 * edge] && !outer_[2 * edge + 1]; }

  /// Around the vertex where h starts, across faces of either kind.
  HalfEdge next_counter_clockwise(HalfEdge h) const { return twin(prev(h)); }
  HalfEdge next_clockwise(HalfEdge h) const { return next(twin(h)); }

  /// The vertex opposite h in the triangle on its left.
  Index apex(HalfEdge h) const { return to(next(h)); }

  /// Turns the edge, an inner one, into the other diagonal of its quadrilateral.
  void flip(Index edge);

  /// Counter-clockwise, each beginning with its least vertex.
  std::vector<Triangle> triangles() const;

 private:
  void link(HalfEdge h, HalfEdge following) {
    next_[h] = following;
    prev_[following] = h;
  }
  void join_outer_face();

  std::vector<Index> from_;
  std::vector<HalfEdge> next_, prev_;
  std::vector<char> outer_;
};

}  // namespace tribunal
