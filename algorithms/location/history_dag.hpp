// The history DAG: every triangle that ever was, each dead one pointing to those that replaced it.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

#include <vector>

namespace tribunal {

/// Point location through the history of a triangulation grown by splits and flips (Guibas, Knuth, Sharir
/// 1992). Its nodes are the triangles of a mesh that never reuses a slot, so a node costs its three child
/// indices and nothing else.
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
  /// `mesh` holds the first triangle `root` and its three ghosts (add_first_triangle).
  HistoryDag(const PlanarProblem& problem, const PlanarMesh& mesh, Index root);

  struct Place {
    Index triangle;  ///< the living triangle that holds the site: finite (boundary included) or the ghost of
                     ///< its cone
    std::uint64_t depth;  ///< nodes on the path, the last one included
  };
  Place locate(Index site) const;

  /// Triangle t was replaced by the star of a new site: child i has the site in place of corner i.
  void split(Index t, const Triangle& children) { children_at(t) = children; }
  /// Triangle t was cut along the line site -> p: `left` = (site, p, .) and `right` = (site, ., p).
  void cut(Index t, Index left, Index right) { children_at(t) = {left, right, PlanarMesh::none}; }

  bool alive(Index t) const { return t >= children_.size() || children_[t][0] == PlanarMesh::none; }

 private:
  Triangle& children_at(Index t);
  Index first_node(Index site) const;
  Index child_holding(const Triangle& children, Index parent, Index site) const;
  Index child_of_star(const Triangle& children, Index parent, Index site) const;
  Index child_of_ghost_star(const Triangle& children, HalfEdge hull_edge, Index site) const;
  Index child_of_cut(const Triangle& children, Index site) const;

  Sign side(Index a, Index b, Index site) const;
  /// On which side of the ray from o through `through` the site lies; never zero for distinct sites.
  Sign side_of_ray(Index through, Index site) const;

  const PlanarProblem& problem_;
  const PlanarMesh& mesh_;
  Index root_;
  Triangle origin_;
  std::vector<Triangle> children_;  // first entry `none`: alive
};

}  // namespace tribunal
