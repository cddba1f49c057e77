// How rough a piecewise linear surface is across an edge: the costs of data-dependent triangulation.
#pragma once

#include "algorithms/flips/quadrilateral.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace tribunal {

enum class Cost : std::uint8_t {
  jump_in_normal_derivatives,  ///< JND: |n . (grad P1 - grad P2)|, n the edge's unit normal
  angle_between_normals,       ///< ABN: of the planes, in [0, pi)
};

enum class Norm : std::uint8_t { l1, l2 };  ///< sum of the costs, or of their squares

/// The costs of the inner edges of triangulations of one data set (Dyn, Levin, Rippa 1990; Barth, section
/// 3.4). Costs are doubles. An edge's cost depends on its ends and the two apexes and not on their order, bit
/// for bit: so the sum over a triangulation, taken exactly, belongs to the triangulation, and what lowers it
/// at each step must end.
class Roughness {
 public:
  /// `values` by point.
  Roughness(std::span<const Point2> points, std::span<const double> values, Cost cost, Norm norm)
      : points_(points), values_(values), cost_(cost), norm_(norm) {}

  /// Of the edge ab between the triangles with apexes p and q. Infinite or NaN where a triangle is so thin
  /// that its gradient overflows.
  double across(Index a, Index b, Index p, Index q) const;

  /// Of an inner edge of a mesh.
  double across(const EdgeMesh& mesh, Index edge) const;

  /// Over all inner edges.
  double total(const EdgeMesh& mesh) const;

  /// What a flip of an inner edge changes: the costs of the edge and of the sides of its quadrilateral,
  /// summed before and after.
  struct Change {
    double before = 0, after = 0;
    double gain() const { return before - after; }
    /// By more than the rounding of such sums, so that the exact sum over all edges falls, too.
    bool is_better() const { return after < before * (1 - 0x1p-40); }
  };
  Change change_by_flip(const EdgeMesh& mesh, Index edge) const;

 private:
  std::array<double, 2> gradient(Index a, Index b, Index c) const;

  std::span<const Point2> points_;
  std::span<const double> values_;
  Cost cost_;
  Norm norm_;
};

}  // namespace tribunal
