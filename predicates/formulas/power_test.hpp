// Position of a ball relative to the sphere orthogonal to D+1 others: the in-sphere test of weighted points.
#pragma once

namespace tribunal {

/// PowerTest<D>::determinant(p): p0..pD and the query pD+1 are balls, points of D+1 coordinates whose last
/// one is the radius. Positive when the query is in conflict with the others, positively oriented: when its
/// power distance to the sphere orthogonal to them all is negative. Balls of equal radii make it InSphere<D>.
/// Over any ring, as Orient<D>.
///
/// A weight is a radius here, so that the formula is homogeneous, and radii are counted from the last
/// coordinate of one more point, pD+2, usually the origin, so that only differences of coordinates are met,
/// as backends ask; its other coordinates do not matter.
///
/// Balls in space have four coordinates: backends that are bound to a box of points take three at most, the
/// others any number.
///
/// The lift of a ball is |center|^2 - radius^2; seen from the query's center and lift it is |difference|^2 -
/// radius^2 + (radius of the query)^2.
template <int D>
struct PowerTest;

template <>
struct PowerTest<2> {
  static constexpr int dimension = 3, points = 5;
  static constexpr auto determinant(const auto& p) {
    const auto ax = p[0][0] - p[3][0], ay = p[0][1] - p[3][1], ar = p[0][2] - p[4][2];
    const auto bx = p[1][0] - p[3][0], by = p[1][1] - p[3][1], br = p[1][2] - p[4][2];
    const auto cx = p[2][0] - p[3][0], cy = p[2][1] - p[3][1], cr = p[2][2] - p[4][2];
    const auto r = p[3][2] - p[4][2];
    return (ax * ax + ay * ay + r * r - ar * ar) * (bx * cy - by * cx) +
           (bx * bx + by * by + r * r - br * br) * (cx * ay - cy * ax) +
           (cx * cx + cy * cy + r * r - cr * cr) * (ax * by - ay * bx);
  }
};

template <>
struct PowerTest<3> {
  static constexpr int dimension = 4, points = 6;
  static constexpr auto determinant(const auto& p) {
    const auto ax = p[0][0] - p[4][0], ay = p[0][1] - p[4][1], az = p[0][2] - p[4][2], ar = p[0][3] - p[5][3];
    const auto bx = p[1][0] - p[4][0], by = p[1][1] - p[4][1], bz = p[1][2] - p[4][2], br = p[1][3] - p[5][3];
    const auto cx = p[2][0] - p[4][0], cy = p[2][1] - p[4][1], cz = p[2][2] - p[4][2], cr = p[2][3] - p[5][3];
    const auto dx = p[3][0] - p[4][0], dy = p[3][1] - p[4][1], dz = p[3][2] - p[4][2], dr = p[3][3] - p[5][3];
    const auto r = p[4][3] - p[5][3];
    const auto ab = ax * by - ay * bx, bc = bx * cy - by * cx, cd = cx * dy - cy * dx;
    const auto da = dx * ay - dy * ax, ac = ax * cy - ay * cx, bd = bx * dy - by * dx;
    const auto abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
    const auto cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
    return (ax * ax + ay * ay + az * az + r * r - ar * ar) * bcd -
           (bx * bx + by * by + bz * bz + r * r - br * br) * cda +
           (cx * cx + cy * cy + cz * cz + r * r - cr * cr) * dab -
           (dx * dx + dy * dy + dz * dz + r * r - dr * dr) * abc;
  }
};

}  // namespace tribunal
