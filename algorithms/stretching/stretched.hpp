// Triangles stretched along walls (Barth section 3.5, "Stretched Triangle Refinement").
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "algorithms/refinement/steiner_mesh.hpp"
#include "algorithms/stretching/spacing.hpp"
#include "algorithms/stretching/walls.hpp"
#include "predicates/kernel.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::stretching {

struct Options {
  Spacing spacing;
  WallChoice walls = WallChoice::inner;
  std::uint64_t most_vertices = 10'000'000;
};

/// What became of the places that were tried for new vertices: each is inserted, or ruled out for good.
struct Counts {
  std::uint64_t inserted = 0;
  std::uint64_t hidden = 0;   ///< ruled out: behind a segment, or outside
  std::uint64_t near = 0;     ///< ruled out: a vertex is closer than the spacing
  std::uint64_t crowded = 0;  ///< ruled out: another wall, or the rim of the domain, is too close
  std::uint64_t trials = 0;   ///< stars grown to compare their largest angles
  std::uint64_t swaps = 0;
  std::uint64_t steps = 0;   ///< triangles looked through
  double worst_measure = 0;  ///< of the triangles left
};

struct Stretched {
  refinement::Refined mesh;
  std::vector<double> distances;  ///< of each point from the walls
  Counts counts;
};

/// Refines the constrained triangulation of the graph's domain, sites inserted in `order`.
///
/// Each vertex v has its distance S(v) from the walls, the way s(v) that leads from there to it, or the ways
/// into the domain where it is on a wall, and the spacing r(v) = spacing.at(S(v)). The measure of a triangle
/// is the largest extent along s(v), from v, over r(v), of its corners v; it fails when that exceeds 1. Of
/// the triangle that fails most, the places v + r(v) s(v) are tried. One is ruled out for good when it cannot
/// be seen from v past the segments; when a vertex other than v is closer than r(v); when the distance from
/// the walls does not grow by r(v) / 2 up to there and on by r(v) / 4 over the next r(v) / 2, where layers
/// from another wall come; when a segment that is no wall is closer than r(v) / 2. Of the others the one is
/// taken whose star has the smallest largest angle. Insertion swaps edges until the mesh is locally MinMax
/// again. It ends when no triangle fails that has a place left.
///
/// S, s and r are rounded: they decide where vertices go. What becomes of the mesh is decided by signs alone.
/// Segments are never split. Throws Abandon: what build_graph_mesh throws, and refused_input for a spacing
/// that is none or takes more than most_vertices, for collinear points, and for domains beyond 2^+-200. O(log
/// n) a vertex where the walls are resolved.
Stretched refine_stretched(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                           const Options& options);

}  // namespace tribunal::stretching
