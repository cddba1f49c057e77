// A triangulation of the plane whose edges may be held fast: insertion of vertices, swaps that respect what
// is held.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

#include <vector>

namespace tribunal::constrained {

/// No piece of a segment lies on the edge.
inline constexpr Index free_edge = 0xFFFFFFFF;

/// Vertices with their positions, triangles with ghosts, and for each edge the piece of a segment that holds
/// it. Vertices are numbered in the order of their insertion, so that neighbours in a spatial order are
/// neighbours in memory.
class Mesh {
 public:
  /// The triangle of three sites that are not collinear, with its ghosts.
  Mesh(const Kernel2& kernel, Point2 a, Point2 b, Point2 c);

  void reserve(std::size_t vertices);

  const PlanarMesh& triangles() const { return mesh_; }
  Index vertices() const { return static_cast<Index>(points_.size()); }
  Point2 point(Index vertex) const { return points_[vertex]; }
  const Kernel2& kernel() const { return kernel_; }
  const Counters& counters() const { return counters_; }

  /// Positive when vertex c lies left of a -> b.
  Sign side(Index a, Index b, Index c) const { return kernel_.orient2d(points_[a], points_[b], points_[c]); }
  /// Whether the finite edge h could be swapped for the other diagonal: its two triangles make a strictly
  /// convex quadrilateral.
  bool swappable(HalfEdge h) const;
  /// Whether the corner across h lies strictly inside the circle of the triangle of h.
  bool violates(HalfEdge h) const;

  Index piece(HalfEdge h) const { return pieces_[h]; }
  bool held(HalfEdge h) const { return pieces_[h] != free_edge; }
  void hold(HalfEdge h, Index piece) { pieces_[h] = pieces_[mesh_.twin(h)] = piece; }

  /// A half-edge opposite `vertex` in one of its triangles, ghosts among them.
  HalfEdge link(Index vertex) const;
  /// The next one counter-clockwise around the vertex opposite h.
  HalfEdge next_link(HalfEdge h) const { return next(mesh_.twin(next(h))); }
  /// The half-edge from a to b, or PlanarMesh::none. O(the smaller degree).
  HalfEdge edge(Index a, Index b) const;

  /// Inserts a new vertex at a position where there is none, by Green and Sibson's swaps: the mesh stays
  /// constrained Delaunay if it was. The walk to it starts at the vertex inserted last, and needs a mesh
  /// without held edges.
  Index insert(Point2 position);

  /// From now on triangles with inside[t] == 0 are left alone: their circles are not restored. What is inside
  /// must be bounded by held edges.
  void confine(std::vector<char> inside);
  bool inside(Index t) const { return inside_[t] != 0; }

  /// Inserts a new vertex strictly inside the finite triangle t; constrained Delaunay if it was.
  Index insert_into(Index t, Point2 position);
  /// Inserts a new vertex between the ends of the edge h, whose halves keep its piece. The position need not
  /// be exactly on the edge if all new triangles are counter-clockwise and it lies in the circles of both old
  /// ones.
  Index insert_on(HalfEdge h, Point2 position);

  /// The same two without any swaps, for criteria other than circles.
  Index place_into(Index t, Point2 position);
  Index place_on(HalfEdge h, Point2 position);

  /// Swaps the diagonal h, not held, of a convex quadrilateral.
  void swap(HalfEdge h);
  /// Swaps edges until none of `suspects` and of those that become suspect violates its circle. Held edges
  /// stay. Returns the number of swaps.
  std::uint64_t restore(std::vector<Edge> suspects);

  /// For those who fill a cavity: gives the triangle t new corners; its edges are then to be attached.
  void replace(Index t, Index a, Index b, Index c);
  /// Takes a triangle whose edges are glued to nothing any more out of the mesh: its place looks like a ghost
  /// until it is used again.
  void discard(Index t);
  /// Glues h to the half-edge across it, whose piece it takes over.
  void attach(HalfEdge h, HalfEdge across) {
    mesh_.glue(h, across);
    pieces_[h] = pieces_[across];
  }
  /// Glues two half-edges of a free edge.
  void join(HalfEdge g, HalfEdge h) {
    mesh_.glue(g, h);
    pieces_[g] = pieces_[h] = free_edge;
  }

 private:
  HalfEdge edge_through(Index t, Index vertex) const;
  Index add_vertex(Point2 position);
  Index add_triangle(Index a, Index b, Index c, Index beside);
  void split_triangle(Index t, Index vertex);
  void split_edge(HalfEdge h, Index vertex);
  void legalise(const PlanarProblem& problem, Index vertex);
  void touch(Index vertex, Index t) {
    if (vertex != infinite) incident_[vertex] = t;
  }

  const Kernel2& kernel_;
  PlanarMesh mesh_;
  std::vector<Point2> points_;
  std::vector<Index> incident_;   // of each vertex, one of its triangles
  std::vector<Index> pieces_;     // of each half-edge
  std::vector<char> inside_;      // of each triangle
  std::vector<Index> discarded_;  // places of triangles that are free
  std::vector<Index> suspects_;   // triangles of the new star, the new vertex at corner 0
  Index last_ = 0;                // a triangle of the vertex inserted last
  bool on_hull_ = false;
  Counters counters_;
};

}  // namespace tribunal::constrained
