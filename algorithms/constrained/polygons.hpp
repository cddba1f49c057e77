// Whether the rings of polygons bound what they are meant to bound.
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "predicates/kernel.hpp"

#include <optional>
#include <span>

namespace tribunal::constrained {

/// The polygons whose rings are segments of a graph.
struct Polygons {
  static constexpr Index no_ring = 0xFFFFFFFF;
  std::span<const Index> ring;   ///< of each segment: its ring, or no_ring
  std::span<const Index> outer;  ///< of each ring: the outer ring of its polygon, itself where it is that
};

/// What makes a polygon none.
struct RingFault {
  enum class Kind { touches_itself, outside_outer_ring } kind;
  Index point;  ///< where, or a corner of the ring that is outside, or one of the outer ring that it holds

  bool operator==(const RingFault&) const = default;
};

/// The first fault of polygons whose segments do not cross: a ring that meets itself in a point, or an inner
/// ring that is not inside its outer one (OGC 06-103r4, 6.1.11). Rings of one polygon may touch each other in
/// points, rings of several may do what they like. `touches` is what the graph's constrained triangulation
/// says of it. O(n log n), and for each corner of an inner ring a look at as many of the outer one's segments
/// as reach its height within a band of about the square root of them; for a ring that touches its outer one
/// twice, for each corner of the outer one, too.
std::optional<RingFault> find_ring_fault(const Graph& graph, const Polygons& polygons,
                                         std::span<const Touch> touches, const Kernel2& kernel);

}  // namespace tribunal::constrained
