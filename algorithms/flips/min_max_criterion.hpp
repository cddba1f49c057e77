// The criterion of MinMax triangulations: the largest angle as small as can be.
#pragma once

#include "algorithms/flips/criterion.hpp"
#include "algorithms/flips/quadrilateral.hpp"

namespace tribunal {

/// The corner {a, apex, b} of the triangle with the largest angle: the one across from its longest side. Of
/// equal ones the first in the triangle. Exact, without angles.
inline Triangle largest_corner(const Sites& sites, const Triangle& t) {
  int longest = 0;  // side i runs from t[i] to t[i + 1]
  for (int i = 1; i < 3; ++i)
    if (sites.compare_length(t[i], t[(i + 1) % 3], t[longest], t[(longest + 1) % 3]) == Sign::positive)
      longest = i;
  return {t[longest], t[(longest + 2) % 3], t[(longest + 1) % 3]};
}

/// The larger of the largest corners of two triangles.
inline Triangle largest_corner(const Sites& sites, const Triangle& t, const Triangle& u) {
  const Triangle p = largest_corner(sites, t), q = largest_corner(sites, u);
  return sites.compare_angle(q, p) == Sign::positive ? q : p;
}

/// Flips the diagonal of a convex quadrilateral when the largest of the six angles becomes strictly smaller
/// (Barth, section 3.4). The angles of the triangulation, from the largest down, then decrease
/// lexicographically, which is why it ends.
class MinMaxCriterion {
 public:
  static constexpr bool implies_convexity = false;
  static constexpr int reach = 1;

  explicit MinMaxCriterion(const Sites& sites) : sites_(sites) {}

  bool improves(const EdgeMesh& mesh, Index edge) const { return improves(quadrilateral(mesh, edge)); }

  bool improves(const Quadrilateral& q) const {
    const Triangle before = largest_corner(sites_, {q.from, q.to, q.left}, {q.to, q.from, q.right});
    const Triangle after = largest_corner(sites_, {q.right, q.left, q.from}, {q.left, q.right, q.to});
    return sites_.compare_angle(after, before) == Sign::negative;
  }

 private:
  Sites sites_;
};
static_assert(FlipCriterion<MinMaxCriterion>);

}  // namespace tribunal
