// A planar straight-line graph as algorithms take it, and what a constrained triangulation of it is.
#pragma once

#include "algorithms/triangulation.hpp"
#include "predicates/point.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tribunal {

/// Which part of the plane is triangulated.
enum class Domain : std::uint8_t {
  hull,      ///< the whole convex hull
  carved,    ///< what neither infinity nor a hole point reaches without crossing a segment
  even_odd,  ///< what is separated from infinity by an odd number of segments, overlapping ones counted each
};

/// Points, segments between them and points that mark holes. Points may coincide; segments may touch, overlap
/// and have no length; crossing inside both is for `split_crossings` to resolve.
struct Graph {
  std::span<const Point2> points;
  std::span<const Edge> segments = {};  ///< by index into points
  std::span<const Point2> holes = {};   ///< used by Domain::carved
  Domain domain = Domain::hull;
};

/// How a missing segment gets into the mesh.
enum class Recovery : std::uint8_t {
  swaps,   ///< by swapping the diagonals of the quadrilaterals that it crosses (Sloan 1993)
  cavity,  ///< by emptying what it crosses and filling both sides (Anglada 1997)
};

/// An input segment passes through a vertex, which splits it.
struct Touch {
  Index segment, vertex;
};

/// Indices are into the graph's points; a duplicate is stood for by its first occurrence.
struct ConstrainedTriangulation {
  Triangulation mesh;             ///< the triangles of the domain; edges and history as in any triangulation
  std::vector<Edge> constraints;  ///< the edges of the whole mesh that lie on segments, each once
  std::vector<Touch> touches;     ///< vertices inside segments
  std::optional<Edge> crossing;   ///< two segments that cross, where that is why it was refused
  std::optional<Index> hole;      ///< the hole at fault, where that is why it was refused
  std::optional<Index> open_end;  ///< a point where a loop is open, where that is why it was refused
  std::uint64_t swaps = 0;        ///< edge swaps made for the sake of segments
};

}  // namespace tribunal
