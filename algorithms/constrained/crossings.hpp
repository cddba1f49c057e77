// Where segments cross: splitting them there, and rounding the crossing points without turning anything
// inside out.
#pragma once

#include "algorithms/abandon.hpp"
#include "algorithms/constrained/graph.hpp"

namespace tribunal {

/// A graph whose segments do not cross: the pieces of another one's.
struct SplitGraph {
  std::vector<Point2> points;  ///< those of the graph, then crossing points
  std::vector<Edge> segments;  ///< those of the graph that nothing crosses, whole, and pieces of the others
  std::vector<Index> origin;   ///< of each of them, the segment of the graph
  std::uint64_t rounded = 0;   ///< crossing points that are no doubles and were moved to the nearest ones
  std::uint64_t snapped =
      0;  ///< vertices that this would have left on the wrong side of a piece: it now ends there

  Graph graph(const Graph& original) const { return {points, segments, original.holes, original.domain}; }
};

/// Rounding crossing points makes new crossings without end; two segments of the graph that take part.
struct UnsettledCrossing : Abandon {
  explicit UnsettledCrossing(Edge pair)
      : Abandon(Outcome::refused_input, "crossings of segments do not settle when they are rounded"),
        segments(pair) {}
  Edge segments;
};

/// Splits segments where two of them cross inside both. Crossing points are computed as rationals and rounded
/// to the nearest doubles; a piece that ends at a rounded point is no longer on its segment, by at most half
/// a unit in the last place. Where that does not settle, the points that are still to come go to coarser and
/// coarser numbers, those of the vertices that are there among them. A vertex that would change sides of a
/// segment by that becomes a vertex of it instead, and whatever crosses anew is split again, until nothing
/// crosses: all by exact signs. Vertices on segments that are not split, and overlaps, are left as they are.
///
/// Throws UnsettledCrossing after `most_rounds` rounds or `most_growth` times the pieces of the first one,
/// and Abandon (refused_input) where a point is not finite. O(n log n) and the pairs of segments whose boxes
/// overlap in x.
SplitGraph split_crossings(const Graph& graph);

}  // namespace tribunal
