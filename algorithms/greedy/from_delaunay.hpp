// The greedy triangulation without all pairs: its next edge is near the Delaunay triangulation.
#pragma once

#include "algorithms/greedy/problem.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal {

/// A greedy triangulation of the problem's domain.
struct GreedyMesh {
  GreedyEdges found;
  std::vector<Triangle> triangles;  ///< counter-clockwise, inside the domain
  std::uint64_t flips = 0;
};

/// From a Delaunay triangulation of the sites, any one where there are several. O(n log n) expected for
/// uniform sites, O(n) storage; the result is the same as from the pool of all pairs.
///
/// After Goldman 1989 and Levcopoulos and Lingas 1992. Let T hold the edges so far and M be a constrained
/// Delaunay triangulation of them, and let ab be the shortest segment that T admits. Beyond ab on one side
/// let z be its apex in a constrained Delaunay triangulation of T and ab. If z is in the closed disk with
/// diameter ab then az and zb are shorter than ab, and both are in T: nothing but z can be seen from ab on
/// that side. If it is so on neither side, the disk shows that ab is in M. Otherwise ab is in M or every edge
/// of M that crosses ab starts at z. So candidates are
///   - the edges of M, and
///   - ears: ab, where za and zb are neighbours around z in T and triangle zab is empty, which it is when the
///     neighbours of z in M between them lie beyond ab.
/// Locking an edge of M changes nothing else in M; cutting an ear replaces the triangles around z that ab
/// crosses.
GreedyMesh triangulate_from_delaunay(const GreedyProblem& problem, std::span<const Triangle> delaunay);

}  // namespace tribunal
