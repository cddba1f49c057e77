// The history DAG: every triangle that ever was, each dead one pointing to those that replaced it.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

/// Point location through the history of a triangulation grown by splits and flips (Guibas, Knuth, Sharir
/// 1992). A node is four indices: that of a living triangle knows its slot in the mesh; that of a dead one
/// keeps a line and what lies on its two sides. Two such lines tell three successors apart.
///
/// Ghosts. The half plane of a ghost is not covered by the half planes of its children, so descending by half
/// planes loses sites. Here the ghost (infinite, u, v) stands for a cone instead: what lies beyond the edge
/// uv, seen from a point o inside the first triangle, between the rays o -> v and o -> u. Cones split and
/// merge exactly as hull edges do, so each site has one path. The point o is symbolic, v0 + e (v1 - v0) + e^2
/// (v2 - v0) for the first triangle v0 v1 v2 and an infinitesimal e > 0: orientations with o are affine in o,
/// so their signs are those of orientations of sites (the first that is not zero), o is never constructed,
/// and no site lies on a ray.
class HistoryDag {
 public:
  /// `mesh` holds the first triangle and its ghosts (add_first_triangle) and nothing else.
  HistoryDag(const PlanarProblem& problem, const PlanarMesh& mesh);

  /// Follows the paths of sites that are to be located next, as far as they lead today: what is dead stays
  /// dead. Side by side, because memory takes as long to answer one question as a dozen.
  void foresee(std::span<const Index> sites);

  /// The living triangle that holds the site: finite (boundary included) or the ghost of its cone. The depth
  /// of its node is noted.
  Index locate(Index site);

  /// After split_triangle: the triangle in slot star[0] became these three.
  void split_triangle(Index site, const Triangle& star);
  /// After split_edge: the triangles in slots star[0] and star[2] became these four, counter-clockwise.
  void split_edge(Index site, const std::array<Index, 4>& star);
  /// After flip_edge: the triangles in these slots became others, cut along site -> p, `left` on its left.
  void flip(Index site, Index p, Index left, Index right);

  std::uint64_t steps() const { return depth_sum_; }
  History shape() const;

 private:
  /// Of a dead triangle: left unless the site is strictly to the right of from -> to, or of the ray from o
  /// through `from` where `to` is infinite. Of a living one: its slot, and no successors.
  struct Node {
    Index from, to, left, right;
  };
  /// Marks a link to the second line of the same triangle.
  static constexpr Index continued = 0x80000000;

  /// How far a site was followed.
  struct Path {
    Index site, at;
    std::uint32_t depth;
  };

  Index add(const Node& node);
  void add_leaf(Index slot) { leaf_of_[slot] = add({slot, 0, PlanarMesh::none, PlanarMesh::none}); }
  Index add_line(const Node& line) { return add(line) | continued; }
  Node fork(Index site, Index p, Index left, Index right) const;
  Node fork_finite(Index site, const Triangle& corner, const Triangle& leaf);
  Node fork_ghost(Index site, Index u, Index v, const Triangle& leaf);

  bool is_leaf(Index node) const { return nodes_[node].left == PlanarMesh::none; }
  Path begin(Index site) const { return {site, first_node(site), 1}; }
  void fetch_line(Index node) const;
  void descend(Path& path) const;
  Index first_node(Index site) const;
  Sign side(Index a, Index b, Index site) const;
  /// On which side of the ray from o through `through` the site lies; never zero for distinct sites.
  Sign side_of_ray(Index through, Index site) const;

  const PlanarProblem& problem_;
  const PlanarMesh& mesh_;
  Triangle origin_;
  std::vector<Node> nodes_;
  std::vector<Index> leaf_of_;  // by slot of the mesh
  std::vector<Path> foreseen_;
  std::vector<std::uint32_t> depths_;
  std::uint64_t depth_sum_ = 0, triangles_ = 4;
};

}  // namespace tribunal
