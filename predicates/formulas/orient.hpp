// Orientation of D+1 points: the sign of the volume they span.
#pragma once

namespace tribunal {

/// Orient<D>::determinant(p) = det(p1-p0, ..., pD-p0), over any ring: numbers need only -, + and *, and the
/// type may change on the way (a difference of coordinates need not be of a coordinate's type).
///
/// D = 2: positive for a counter-clockwise triple; twice the signed area.
/// D = 3: positive when p3 is on the side of the plane p0 p1 p2 from which they turn counter-clockwise seen
/// from the other side, i.e. det(b-a, c-a, d-a) > 0; six times the signed volume. This is CGAL::orientation
/// and minus Shewchuk's orient3d. Barth's (3.7.0) calls the same determinant of (1,2,3,4) positive for his
/// T1.
template <int D>
struct Orient;

template <>
struct Orient<2> {
  static constexpr int dimension = 2, points = 3;
  static constexpr auto determinant(const auto& p) {
    const auto bx = p[1][0] - p[0][0], by = p[1][1] - p[0][1];
    const auto cx = p[2][0] - p[0][0], cy = p[2][1] - p[0][1];
    return bx * cy - by * cx;
  }
};

template <>
struct Orient<3> {
  static constexpr int dimension = 3, points = 4;
  static constexpr auto determinant(const auto& p) {
    const auto bx = p[1][0] - p[0][0], by = p[1][1] - p[0][1], bz = p[1][2] - p[0][2];
    const auto cx = p[2][0] - p[0][0], cy = p[2][1] - p[0][1], cz = p[2][2] - p[0][2];
    const auto dx = p[3][0] - p[0][0], dy = p[3][1] - p[0][1], dz = p[3][2] - p[0][2];
    return bz * (cx * dy - cy * dx) + cz * (dx * by - dy * bx) + dz * (bx * cy - by * cx);
  }
};

}  // namespace tribunal
