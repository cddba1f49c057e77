// Data-dependent flips: a diagonal is better when the surface is less rough around it.
#pragma once

#include "algorithms/data_dependent/roughness.hpp"
#include "algorithms/flips/criterion.hpp"

namespace tribunal {

/// Flips the diagonal of a convex quadrilateral where the sum of all costs becomes smaller, of which the edge
/// and the sides of its quadrilateral have changed (Barth, section 3.4).
class RoughnessCriterion {
 public:
  static constexpr bool implies_convexity = false;
  static constexpr int reach = 2;

  explicit RoughnessCriterion(const Roughness& roughness) : roughness_(roughness) {}
  bool improves(const EdgeMesh& mesh, Index edge) const {
    return roughness_.change_by_flip(mesh, edge).is_better();
  }

 private:
  const Roughness& roughness_;
};
static_assert(FlipCriterion<RoughnessCriterion>);

}  // namespace tribunal
