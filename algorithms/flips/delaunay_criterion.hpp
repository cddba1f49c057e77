// Lawson's criterion: no site inside a circle.
#pragma once

#include "algorithms/flips/criterion.hpp"
#include "algorithms/flips/quadrilateral.hpp"

namespace tribunal {

/// Flips an edge when the apex across it lies strictly inside the circle: the least of the six angles then
/// grows (Lawson 1977; Sibson 1978). A quadrilateral that is not strictly convex never violates the circle
/// test (Barth, section 3.3d), so that convexity need not be asked. Ties are left as they are: flipping them
/// would never end.
class DelaunayCriterion {
 public:
  static constexpr bool implies_convexity = true;
  static constexpr int reach = 1;

  explicit DelaunayCriterion(const Sites& sites) : sites_(sites) {}

  bool improves(const EdgeMesh& mesh, Index edge) const {
    const Quadrilateral q = quadrilateral(mesh, edge);
    return sites_.incircle(q.from, q.to, q.left, q.right) == Sign::positive;
  }

 private:
  Sites sites_;
};
static_assert(FlipCriterion<DelaunayCriterion>);

}  // namespace tribunal
