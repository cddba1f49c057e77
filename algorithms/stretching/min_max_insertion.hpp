// Insertion of vertices into a triangulation that is locally MinMax: no swap makes the larger angle smaller.
#pragma once

#include "algorithms/constrained/mesh.hpp"
#include "algorithms/refinement/sight.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::stretching {

/// The corner {a, apex, b} of a triangle with its largest angle: across from the longest side. Of equal ones
/// the first. Exact.
Angle<2> largest_corner(const Kernel2& kernel, Point2 a, Point2 b, Point2 c);

/// Green and Sibson's insertion with the angles of two triangles in the place of the circle, and with swaps
/// that go on behind the new vertex, too, which this criterion needs (Barth section 3.4). Held edges stay and
/// nothing outside the domain is touched. All decisions are signs of the kernel.
class MinMaxInsertion {
 public:
  /// Swaps edges of the confined mesh until it is locally MinMax.
  explicit MinMaxInsertion(constrained::Mesh& mesh);

  /// The largest corner of the triangles that the swaps forward would leave around a new vertex, sighted
  /// inside a triangle or on a free edge; the mesh stays as it is.
  Angle<2> largest_around(Point2 p, const refinement::Sighting& where);

  /// Inserts it. O(1) swaps as a rule.
  Index insert(Point2 p, const refinement::Sighting& where);

  /// Swaps until no circle is violated and then, from there, until the mesh is locally MinMax. What grew by
  /// insertions has worse local optima than this one, as a rule.
  void swap_anew();

  /// The triangles that the last insertion made or changed, each once.
  std::span<const Index> changed() const { return changed_; }
  std::uint64_t swaps() const { return swaps_; }

 private:
  struct Suspect {
    HalfEdge at;
    Index from, to;  // what it runs between: else a swap has moved the edge, and it waits under its new name
  };
  bool may_swap(HalfEdge h) const;
  bool improves(Point2 s, Point2 a, Point2 p, Point2 b) const;
  void suspect(HalfEdge h);
  void suspect_all();
  void swap_suspects();

  constrained::Mesh& mesh_;
  std::vector<Suspect> suspects_;
  std::vector<HalfEdge> star_;
  std::vector<Index> changed_;
  std::uint64_t swaps_ = 0;
};

}  // namespace tribunal::stretching
