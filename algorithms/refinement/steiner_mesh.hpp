// The constrained Delaunay mesh of a domain, into which Steiner points go and out of which they come again.
#pragma once

#include "algorithms/refinement/domain_mesh.hpp"
#include "algorithms/refinement/sight.hpp"
#include "algorithms/refinement/subsegments.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace tribunal::refinement {

/// What refinement makes of a graph.
struct Refined {
  std::vector<Point2> points;  ///< the graph's, in its order, then the Steiner points
  std::vector<Triangle> triangles;
  std::vector<Subsegment> subsegments;
};

/// What may be done with a vertex.
enum class Role : std::uint8_t {
  input,       ///< one of the graph's points: stays
  on_segment,  ///< a Steiner point on a held edge: stays
  free,        ///< a Steiner point that may be removed
  removed,
};

/// Every operation leaves a constrained Delaunay triangulation of the domain, no cell inverted or flat, each
/// segment a path of held edges. What lies outside the domain is not kept in order. All decisions are signs
/// of the kernel; a point that it does not admit ends in Abandon (out_of_domain).
class SteinerMesh {
 public:
  /// The mesh of the graph's domain, sites inserted in `order` (a permutation of all points). Throws as
  /// build_domain_mesh does.
  SteinerMesh(const Graph& graph, std::span<const Index> order, const Kernel2& kernel);

  const constrained::Mesh& mesh() const { return mesh_; }
  const PlanarMesh& triangles() const { return mesh_.triangles(); }
  bool in_domain(Index t) const { return mesh_.inside(t); }
  Point2 point(Index vertex) const { return mesh_.point(vertex); }
  std::array<Point2, 3> corners(Index t) const {
    const Triangle v = triangles().triangle(t);
    return {point(v[0]), point(v[1]), point(v[2])};
  }
  Role role(Index vertex) const { return roles_[vertex]; }
  std::size_t vertices() const { return roles_.size() - removed_; }
  std::uint64_t steps() const { return steps_; }

  /// The domain's triangles around a vertex: after an insertion or a split, those that are new.
  template <class Visit>
  void for_star(Index vertex, Visit visit) const {
    const HalfEdge first = mesh_.link(vertex);
    HalfEdge h = first;
    do {
      if (in_domain(triangle_of(h))) visit(triangle_of(h));
      h = mesh_.next_link(h);
    } while (h != first);
  }

  /// Where p is seen from a triangle of the domain.
  Sighting look(Index t, Point2 p);

  /// Inserts p, a new free vertex, where it was sighted: inside, or on a free edge.
  Index insert(Point2 p, const Sighting& where);

  /// The stretch of the half-edge h, held, on its piece of a segment between two input vertices: parameters
  /// of its start and its end, 0 and 1 at the ends of the piece.
  std::array<double, 2> stretch(HalfEdge h) const;
  /// The input vertices at the ends of that piece.
  const Edge& piece_ends(HalfEdge h) const { return piece_ends_[mesh_.piece(h)]; }

  /// Splits the held edge h at parameter t of its piece: at the double point nearest to that place on the
  /// segment, so that bends do not add up, or at one at most two doubles away in x and in y, where the
  /// nearest one lies outside the circles beside the edge, would invert a cell or make the domain grow. Where
  /// all of them do, as they may where earlier bends are worth more doubles than two, the same around that
  /// place on the edge itself. Nothing, and nothing is changed, where these do, too, or where no double lies
  /// between.
  std::optional<Index> split(HalfEdge h, double t);
  /// In the middle.
  std::optional<Index> split(HalfEdge h);

  /// Removes a free vertex. Returns the triangles that fill its star.
  std::vector<Index> remove(Index vertex);

  Refined result() const;

 private:
  SteinerMesh(const Graph& graph, constrained::GraphMesh built);
  std::optional<Point2> place_near(HalfEdge h, Point2 place) const;
  bool admits_split(HalfEdge h, Point2 p) const;
  double parameter(Index piece, Index vertex) const;
  void require_admitted(Point2 p) const;

  constrained::Mesh mesh_;
  std::vector<Point2> input_;
  std::vector<Index> input_vertex_;         // of each input point
  std::vector<std::array<Index, 2>> runs_;  // segment, piece: each piece of each segment
  std::vector<Edge> piece_ends_;            // input vertices
  std::vector<Role> roles_;                 // of each vertex
  std::vector<double> parameters_;          // of each vertex on a segment
  std::size_t removed_ = 0;
  std::uint64_t steps_ = 0;
};

}  // namespace tribunal::refinement
