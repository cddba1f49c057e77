#include "algorithms/insertion/circle_extent.hpp"

#include <cmath>
#include <limits>

namespace tribunal {

// With a as origin the centre is (x, y) = (cy B - by C, bx C - cx B) / (2 D), where B = |b|^2, C = |c|^2 and
// D = bx cy - by cx. Let u = 2^-53. Each computed difference is off by a factor 1 + e, |e| <= u, so
//   - a squared length carries at most 4 roundings and a term such as cy B at most 6, its sum 7: the error of
//   a
//     numerator is at most 8u (|cy| B + |by| C), second-order terms and the rounding of this sum included;
//   - likewise the error of D is at most 5u (|bx cy| + |by cx|).
// If numerator N has error n and D has error d < |D|, then |N/D - N'/D'| <= (n + |N/D| d) / (|D| - d). All
// the bounds below are enlarged by 1 + 2^-40, far more than the roundings made in computing them. Underflow
// would void the relative errors, so differences below 2^-300 or above 2^300 in size get no bound:
// a numerator is of degree three in them.
double right_extent(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr double u = 0x1p-53, enlarge = 1 + 0x1p-40;
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  for (const double difference : {bx, by, cx, cy}) {
    const double size = std::fabs(difference);
    if (size != 0 && !(size > 0x1p-300 && size < 0x1p300)) return none;
  }
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double d = bx * cy - by * cx;
  const double d_error = 5 * u * (std::fabs(bx * cy) + std::fabs(by * cx)) * enlarge;
  const double d_least = (std::fabs(d) - d_error) / enlarge;
  if (!(d_least > 0)) return none;
  const double x = (cy * b2 - by * c2) / d, y = (bx * c2 - cx * b2) / d;
  const double x_error =
      (8 * u * (std::fabs(cy) * b2 + std::fabs(by) * c2) + std::fabs(x) * d_error) / d_least;
  const double y_error =
      (8 * u * (std::fabs(bx) * c2 + std::fabs(cx) * b2) + std::fabs(y) * d_error) / d_least;
  const double x_bound = std::fabs(x) * 2 * u + x_error, y_most = std::fabs(y) * enlarge + y_error;
  const double x_most = std::fabs(x) * enlarge + x_error;
  const double centre = x / 2 + x_bound * enlarge, radius = std::hypot(x_most, y_most) / 2 * enlarge;
  const double magnitude = std::fabs(a[0]) + std::fabs(centre) + radius;
  return a[0] + centre + radius + magnitude * 4 * u;
}

}  // namespace tribunal
