// Position of a point relative to the sphere through D+1 others.
#pragma once

namespace tribunal {

/// InSphere<D>::determinant(p): p0..pD span the sphere, pD+1 is the query; positive when the query is
/// strictly inside the sphere of positively oriented points. Over any ring, as Orient<D>.
///
/// With rows (p_i - q, |p_i - q|^2) this is PLUS the determinant in the plane and MINUS it in space, for our
/// orientation conventions; the determinant printed by Barth in section 3.7 is therefore negative inside when
/// his tetrahedron is positively oriented.
template <int D>
struct InSphere;

template <>
struct InSphere<2> {
  static constexpr int dimension = 2, points = 4;
  static constexpr auto determinant(const auto& p) {
    const auto ax = p[0][0] - p[3][0], ay = p[0][1] - p[3][1];
    const auto bx = p[1][0] - p[3][0], by = p[1][1] - p[3][1];
    const auto cx = p[2][0] - p[3][0], cy = p[2][1] - p[3][1];
    return (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
           (cx * cx + cy * cy) * (ax * by - ay * bx);
  }
};

template <>
struct InSphere<3> {
  static constexpr int dimension = 3, points = 5;
  static constexpr auto determinant(const auto& p) {
    const auto ax = p[0][0] - p[4][0], ay = p[0][1] - p[4][1], az = p[0][2] - p[4][2];
    const auto bx = p[1][0] - p[4][0], by = p[1][1] - p[4][1], bz = p[1][2] - p[4][2];
    const auto cx = p[2][0] - p[4][0], cy = p[2][1] - p[4][1], cz = p[2][2] - p[4][2];
    const auto dx = p[3][0] - p[4][0], dy = p[3][1] - p[4][1], dz = p[3][2] - p[4][2];
    // The six 2x2 minors in x and y serve all four 3x3 cofactors.
    const auto ab = ax * by - ay * bx, bc = bx * cy - by * cx, cd = cx * dy - cy * dx;
    const auto da = dx * ay - dy * ax, ac = ax * cy - ay * cx, bd = bx * dy - by * dx;
    const auto abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
    const auto cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
    return (ax * ax + ay * ay + az * az) * bcd - (bx * bx + by * by + bz * bz) * cda +
           (cx * cx + cy * cy + cz * cz) * dab - (dx * dx + dy * dy + dz * dz) * abc;
  }
};

}  // namespace tribunal
