// The convexity test of two tetrahedra that share a face (Barth, eq. 3.7.0).
#pragma once

#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace tribunal {

/// The signs of the barycentric coordinates b_1, ..., b_4 of e in the tetrahedron of four points that are not
/// coplanar. `kernel` answers orient3d: a Kernel3, or anything that does.
///
/// By Cramer's rule b_i = D_i / D, where D = det(1,2,3,4) and D_i has e in the place of point i. The text
/// prints sign D_i alone, which holds for D > 0; here the sign of D is taken into account.
template <class Kernel>
std::array<Sign, 4> barycentric_signs(const Kernel& kernel, const std::array<Point3, 4>& tetrahedron,
                                      Point3 e) {
  const auto orientation = [&](const std::array<Point3, 4>& p) {
    return kernel.orient3d(p[0], p[1], p[2], p[3]);
  };
  const Sign positive = orientation(tetrahedron);
  assert(positive != Sign::zero);
  std::array<Sign, 4> signs{};
  for (std::size_t i = 0; i < 4; ++i) {
    auto replaced = tetrahedron;
    replaced[i] = e;
    signs[i] = orientation(replaced) * positive;
  }
  return signs;
}

/// Whether the tetrahedra (1,2,3,4) and (1,2,3,e) form a strictly convex body: e lies beyond the face
/// (1,2,3), inside the cone that point 4 spans with it. A zero among b_1, b_2, b_3 means that the segment
/// from 4 to e meets an edge or a point of the face: then four points are coplanar, and the flips differ
/// (2-2, 4-4).
constexpr bool is_strictly_convex(const std::array<Sign, 4>& barycentric) {
  return std::all_of(barycentric.begin(), barycentric.begin() + 3,
                     [](Sign b) { return b == Sign::positive; }) &&
         barycentric[3] == Sign::negative;
}

}  // namespace tribunal
