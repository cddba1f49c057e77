// Small angles of the input, which no refinement can enlarge, and how segments are split near them.
#pragma once

#include "algorithms/refinement/shape.hpp"
#include "algorithms/refinement/steiner_mesh.hpp"

#include <cstdint>
#include <vector>

namespace tribunal::refinement {

/// An apex is an input vertex where two segments enclose less than 60 degrees of the domain. Splits of the
/// segments there lie on concentric circles around it, whose radii are powers of two and the middles between
/// them: then what one segment needs, all others at the apex have, too, and splits do not chase each other
/// towards it (Ruppert 1995; Shewchuk 2000; Miller, Pav, Walkington 2003).
class SmallAngles {
 public:
  /// Looks around every vertex. `bound` is the smallest angle asked for.
  SmallAngles(const SteinerMesh& mesh, AngleBound bound);

  /// Angles of the input, inside the domain, that are below the bound.
  std::uint64_t below_bound() const { return below_bound_; }

  /// Where to split the held edge h: the parameter on its piece. In the middle, but on a circle next to an
  /// apex.
  double place_to_split(const SteinerMesh& mesh, HalfEdge h) const;
  /// Notes that a split there, of the edge between these ends, made `vertex`.
  void note_split(const SteinerMesh& mesh, Edge ends, Index vertex);

  /// Whether an angle of the input forces the shape of a triangle: its shortest edge joins two segments of an
  /// apex on one circle, or its two longer edges are equally long parts of them.
  bool forces(const SteinerMesh& mesh, Index t) const;

 private:
  /// The circle of a vertex on a segment: its apex and radius, no_apex where there is none.
  struct Circle {
    Index apex;
    double radius;
  };
  static constexpr Index no_apex = 0xFFFFFFFF;
  Circle circle(Index vertex) const {
    return vertex < circles_.size() ? circles_[vertex] : Circle{no_apex, 0};
  }
  bool is_apex(Index vertex) const { return vertex < apex_.size() && apex_[vertex] != 0; }

  std::vector<char> apex_;
  std::vector<Circle> circles_;
  std::uint64_t below_bound_ = 0;
};

}  // namespace tribunal::refinement
