#include "algorithms/refinement/shape.hpp"

#include "algorithms/direction.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace tribunal::refinement {
namespace {

/// The index of the corner at the shortest edge's other side: where the smallest angle is.
std::size_t sharpest(const std::array<double, 3>& edges) {
  return static_cast<std::size_t>(std::min_element(edges.begin(), edges.end()) - edges.begin());
}

/// At each corner, whether cross^2 < sine^2 |u|^2 |v|^2. An angle's sine is less than the bound's, which is
/// at most that of 60 degrees, where the angle is less than the bound or more than 180 degrees minus it; then
/// another angle is less.
bool is_sharper_exactly(const Corners& triangle, const mpq_class& sine_squared) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 p = triangle[i], q = triangle[(i + 1) % 3], r = triangle[(i + 2) % 3];
    const mpq_class ux = mpq_class(q[0]) - p[0], uy = mpq_class(q[1]) - p[1];
    const mpq_class vx = mpq_class(r[0]) - p[0], vy = mpq_class(r[1]) - p[1];
    const mpq_class cross = ux * vy - uy * vx;
    const mpq_class product = (ux * ux + uy * uy) * (vx * vx + vy * vy);
    if (cross * cross < sine_squared * product) return true;
  }
  return false;
}

std::array<double, 3> squared_edges(const Corners& t) {
  std::array<double, 3> edges{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 p = t[(i + 1) % 3], q = t[(i + 2) % 3];
    const double x = q[0] - p[0], y = q[1] - p[1];
    edges[i] = x * x + y * y;
  }
  return edges;
}

}  // namespace

AngleBound AngleBound::degrees(double angle) {
  if (angle == 30) return {0.25};  // the one everybody means exactly
  const double sine = std::sin(angle * std::numbers::pi / 180);
  return {sine * sine};
}

AngleBound AngleBound::radius_to_edge(double ratio) { return {0.25 / (ratio * ratio)}; }

std::string text_of(Point2 p) {
  std::array<char, 64> text{};
  const auto shortest = [&](double x) {
    return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr);
  };
  return "x = " + shortest(p[0]) + ", y = " + shortest(p[1]);
}

double distance(Point2 a, Point2 b) {
  const double x = b[0] - a[0], y = b[1] - a[1], squared = x * x + y * y;
  if (0x1p-900 < squared && squared < 0x1p900) return std::sqrt(squared);
  const double longer = std::max(std::fabs(x), std::fabs(y));
  if (longer == 0) return 0;
  const int exponent = std::ilogb(longer);
  const double u = std::ldexp(x, -exponent), v = std::ldexp(y, -exponent);
  return std::ldexp(std::sqrt(u * u + v * v), exponent);
}

std::array<double, 3> edge_lengths(const Corners& t) {
  return {distance(t[1], t[2]), distance(t[2], t[0]), distance(t[0], t[1])};
}

int excess_exponent(const Corners& t) {
  constexpr int usual = 200;  // the fifth power of 2^200 is a double
  double longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      longest = std::max(longest, std::fabs(t[i][axis] - t[0][axis]));
  const int exponent = std::ilogb(longest);
  return -usual < exponent && exponent < usual ? 0 : exponent;
}

Point2 scaled(Point2 p, int exponent) { return {{std::ldexp(p[0], exponent), std::ldexp(p[1], exponent)}}; }

Corners scaled(const Corners& t, int exponent) {
  return {scaled(t[0], exponent), scaled(t[1], exponent), scaled(t[2], exponent)};
}

// The filter. With u = 2^-53 a rounded difference is off by a factor 1 + u, a squared length by (1 + u)^4, so
// that the right side, six roundings more, is off by less than (1 + u)^16, 1 + 17 u at most. The rounded
// cross product is off by less than e = 5 u (|ux vy| + |uy vx|): two differences, a product and the final
// subtraction, each u of at most that sum. Where |cross| + e or |cross| - e, squared, three roundings more,
// decides, it decides rightly. All that holds while nothing overflows or comes near the smallest numbers.
//
// It asks only at the corner opposite the shortest edge as rounded; where another edge is about as short, the
// angles there are about equal, and the other corners are asked by rational numbers when the answer is close:
// an angle that is smaller by more than a factor 1 + 16 u lies opposite a rounded edge that is shorter.
bool is_sharper(const Corners& t, AngleBound bound) {
  constexpr double u = 0x1p-53;
  const std::array<double, 3> edges = squared_edges(t);
  const std::size_t i = sharpest(edges);
  const Point2 p = t[i], q = t[(i + 1) % 3], r = t[(i + 2) % 3];
  const double first = (q[0] - p[0]) * (r[1] - p[1]), second = (q[1] - p[1]) * (r[0] - p[0]);
  const double cross = std::fabs(first - second), error = 5 * u * (std::fabs(first) + std::fabs(second));
  const double right = bound.sine_squared * (edges[(i + 1) % 3] * edges[(i + 2) % 3]);
  if (0x1p-900 < right && right < 0x1p900) {
    const double most = (cross + error) * (cross + error), least = (cross - error) * (cross - error);
    if (most * (1 + 64 * u) < right * (1 - 64 * u)) return true;
    if (cross > error && least * (1 - 64 * u) > right * (1 + 64 * u)) return false;
  }
  return is_sharper_exactly(t, mpq_class(bound.sine_squared));
}

double circumradius(const Corners& t) {
  if (const int excess = excess_exponent(t)) return std::ldexp(circumradius(scaled(t, -excess)), excess);
  const std::array<double, 3> e = edge_lengths(t);
  const double cross = (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
  return cross > 0 ? e[0] * e[1] / (2 * cross) * e[2] : std::numeric_limits<double>::infinity();
}

Point2 circumcentre(const Corners& t) {
  if (const int excess = excess_exponent(t)) return scaled(circumcentre(scaled(t, -excess)), excess);
  const std::array<double, 3> edges = squared_edges(t);
  // From the corner opposite the longest edge the terms are the smallest.
  const auto i = static_cast<std::size_t>(std::max_element(edges.begin(), edges.end()) - edges.begin());
  const Point2 a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  const double twice = 2 * (bx * cy - by * cx);
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / twice, y = (bx * c2 - cx * b2) / twice;
  const Point2 centre{{a[0] + x, a[1] + y}};
  if (twice > 0 && std::isfinite(centre[0]) && std::isfinite(centre[1])) return centre;
  // Beyond the middle of the longest edge, bc, seen from a: that is to its right.
  constexpr double far = 0x1p40;
  return {{b[0] / 2 + c[0] / 2 + far * (c[1] - b[1]), b[1] / 2 + c[1] / 2 - far * (c[0] - b[0])}};
}

std::array<double, 2> extreme_angles(const Corners& t) {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 p = t[i], q = t[(i + 1) % 3], r = t[(i + 2) % 3];
    const auto [ux, uy] = direction(p, q);
    const auto [vx, vy] = direction(p, r);
    // Of a corner of nearly 180 degrees the product may round to the wrong side of zero.
    angles[i] = std::atan2(std::fabs(ux * vy - uy * vx), ux * vx + uy * vy) * 180 / std::numbers::pi;
  }
  const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
  return {*least, *most};
}

}  // namespace tribunal::refinement
