// What leads stretched refinement at each vertex: its distance from the walls, the ways away from them, the
// spacing.
#pragma once

#include "algorithms/stretching/spacing.hpp"
#include "algorithms/stretching/walls.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace tribunal::stretching {

/// One way away from one vertex: a number.
using Step = std::uint32_t;

class Guides {
 public:
  /// Of all vertices of the mesh.
  Guides(const constrained::Mesh& mesh, const Spacing& spacing, WallChoice choice);

  /// And of the next one, in the domain. O(log n).
  void add(Point2 p);

  double distance(Index v) const { return distances_[v]; }
  double spacing(Index v) const { return spacing_.at(distances_[v]); }

  /// The steps from v are those up to the first one from v + 1.
  Step first_step(Index v) const { return first_steps_[v]; }
  /// Whether it is to be tried still.
  bool is_open(Step step) const { return open_[step] != 0; }
  void close(Step step) { open_[step] = 0; }
  /// Where the step from v, at `from`, leads.
  Point2 place(Point2 from, Index v, Step step) const { return forward(from, step, spacing(v)); }

  /// Whether a vertex there, one step from v, leaves room for the layers of other walls, and to the rim.
  bool has_room(Point2 place, Index v, Step step) const;

  /// The measure of a triangle, see refine_stretched. Of several ways from a corner the one counts that is
  /// nearest to the triangle's middle.
  double measure(const constrained::Mesh& mesh, Index t) const;

 private:
  Point2 forward(Point2 from, Step step, double by) const {
    return {{from[0] + by * ways_[step][0], from[1] + by * ways_[step][1]}};
  }
  Guides(const constrained::Mesh& mesh, const Spacing& spacing, const Boundary& boundary);
  void append(double distance, const std::vector<Vector>& ways);

  Spacing spacing_;
  SegmentTree walls_;
  std::optional<SegmentTree> rim_;
  std::vector<double> distances_;
  std::vector<Step> first_steps_{0};
  std::vector<Vector> ways_;  // of each step
  std::vector<char> open_;
};

}  // namespace tribunal::stretching
