// Point location by a walk that ends in any triangulation, Delaunay or not.
#pragma once

#include "algorithms/abandon.hpp"
#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"
#include "datasets/random.hpp"

namespace tribunal {

/// The visibility walk can run in circles where circles are not empty. Asked about its edges in random order
/// it leaves every such circle in the end (Devillers, Pion, Teillaud 2002). Walks start where the last one
/// ended. The coins are its own, so that the same sites in the same order take the same way.
class StochasticWalk {
 public:
  StochasticWalk(const PlanarProblem& problem, const PlanarMesh& mesh) : problem_(problem), mesh_(mesh) {}

  /// The next walk starts here.
  void start_at(Index t) { at_ = t; }

  /// A finite triangle that contains the site (boundary included) or a ghost whose hull edge sees it from
  /// strictly outside. Adds its steps to `steps`.
  Index locate(Index site, std::uint64_t& steps) {
    Budget budget(64 + 16 * std::uint64_t{mesh_.triangles()}, "walk");
    if (const HalfEdge hull_edge = mesh_.ghost_corner(at_); hull_edge != PlanarMesh::none)
      at_ = triangle_of(mesh_.twin(hull_edge));
    for (;;) {
      budget.spend();
      ++steps;
      const HalfEdge exit = exit_towards(site);
      if (exit == PlanarMesh::none) return at_;
      at_ = triangle_of(mesh_.twin(exit));
      if (mesh_.is_ghost(at_)) return at_;
    }
  }

 private:
  HalfEdge exit_towards(Index site) {
    const auto& p = problem_.points;
    HalfEdge h = 3 * at_ + static_cast<HalfEdge>(random_.below(3));
    for (int i = 0; i < 3; ++i, h = next(h))
      if (problem_.kernel.orient2d(p[mesh_.from(h)], p[mesh_.to(h)], p[site]) == Sign::negative) return h;
    return PlanarMesh::none;
  }

  const PlanarProblem& problem_;
  const PlanarMesh& mesh_;
  Random random_{1};
  Index at_ = 0;
};

}  // namespace tribunal
