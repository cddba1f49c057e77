#include "algorithms/verify/exact_signs.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#if defined(__FAST_MATH__)
#error "The checker's error bounds do not hold under -ffast-math"
#endif

namespace tribunal::verify {
namespace {

// ---- The formulas: each once, over any number type. GMP's operators yield lazy expressions, so no `auto`.

template <class Number>
struct Vector {
  Number x, y;
};

template <class Number>
Number cross(const Vector<Number>& p, const Vector<Number>& q) {
  return p.x * q.y - p.y * q.x;
}

template <class Number>
Number dot(const Vector<Number>& p, const Vector<Number>& q) {
  return p.x * q.x + p.y * q.y;
}

// |p x q| and |p . q| with each product replaced by its absolute value.
double cross_magnitude(const Vector<double>& p, const Vector<double>& q) {
  return std::abs(p.x * q.y) + std::abs(p.y * q.x);
}
double dot_magnitude(const Vector<double>& p, const Vector<double>& q) {
  return std::abs(p.x * q.x) + std::abs(p.y * q.y);
}

// ---- The filters.
//
// Rounding to nearest with unit u = 2^-53: fl(x +- y) = (x +- y)(1 + d), |d| <= u, also when the result is
// subnormal; fl(x y) = x y (1 + d) + e, |e| <= h = 2^-1075, the e being there only for underflow. Write M for
// the sum of the absolute values of the products of a formula, over the exact differences of coordinates, and
// M' for the computed one.
//
// A term carries one factor (1 + d) for each rounding on its way: a difference 1; a product of two
// differences 3; a cross or dot product 4; a product of two of those 9; their sum 10. Without underflow a
// formula with k factors is off by
//   E <= ((1 + u)^k - 1) M <= ((1 + u)^k - 1) (1 - u)^-k M' < (k + 1/2) u M'   for k <= 10,
// and (k + 1) u covers the rounding of the bound itself: 5 u M' for an orientation, 11 u M' for the two
// angles; we take 12 u.
//
// Underflow shifts a cross or dot product, and its magnitude, by at most 2 h (1 + u) < 3 h. An orientation is
// then off by 3 h, and M' is short by 3 h. In the angles each product of two such factors f, g is shifted by
// at most 3 h (|f| + |g|) + 9 h^2 + h; with W the sum of the four magnitudes, the whole is off by less than 4
// h W + 4 h, and M' is short by as much. `underflow` (1 + W) with underflow = 2^-1000 is far above (1 + 12 u)
// times that, and, being a normal number, costs no slow subnormal arithmetic.
//
// Overflow: every operation on magnitudes repeats one on the terms with absolute values, and rounding is
// monotone, so |value| <= M' or a NaN is among the operands. An infinite or NaN value therefore comes with an
// infinite or NaN bound, and `beyond` is false for it. So the filters are sound for all finite doubles.
constexpr double unit = 0x1p-53;
constexpr double underflow = 0x1p-1000;

/// The sign of a value known up to +-bound; nothing where the bound does not settle it.
std::optional<Sign> beyond(double value, double bound) {
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return std::nullopt;
}

Vector<double> rounded_difference(Point2 p, Point2 q) { return {p[0] - q[0], p[1] - q[1]}; }

std::optional<Sign> filtered_orientation(Point2 a, Point2 b, Point2 c) {
  const Vector<double> p = rounded_difference(a, c), q = rounded_difference(b, c);
  return beyond(cross(p, q), 5 * unit * cross_magnitude(p, q) + underflow);
}

std::optional<Sign> filtered_opposite_angles(Point2 a, Point2 b, Point2 u, Point2 v) {
  const Vector<double> au = rounded_difference(u, a), av = rounded_difference(v, a);
  const Vector<double> bu = rounded_difference(u, b), bv = rounded_difference(v, b);
  const double value = cross(au, av) * dot(bv, bu) + dot(au, av) * cross(bv, bu);
  const double sine_a = cross_magnitude(au, av), cosine_a = dot_magnitude(au, av);
  const double sine_b = cross_magnitude(bv, bu), cosine_b = dot_magnitude(bv, bu);
  const double magnitude = sine_a * cosine_b + cosine_a * sine_b;
  const double sum = (sine_a + cosine_a) + (sine_b + cosine_b);
  return beyond(value, 12 * unit * magnitude + underflow * (1 + sum));
}

// ---- The exact values.

/// A finite double as an integer times a power of two.
struct Scaled {
  std::int64_t mantissa;
  int exponent;
};

Scaled scaled(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

/// Points as integers, by one common power of two: signs of homogeneous polynomials are kept.
template <std::size_t N>
std::array<Vector<mpz_class>, N> to_integers(const std::array<Point2, N>& points) {
  int smallest = std::numeric_limits<int>::max();
  for (const Point2& p : points)
    for (const double c : p.coordinate)
      if (c != 0) smallest = std::min(smallest, scaled(c).exponent);
  const auto integer = [smallest](double c) {
    if (c == 0) return mpz_class(0);
    const Scaled s = scaled(c);
    return mpz_class(mpz_class(static_cast<long>(s.mantissa))
                     << static_cast<mp_bitcnt_t>(s.exponent - smallest));
  };
  std::array<Vector<mpz_class>, N> integers;
  for (std::size_t i = 0; i < N; ++i) integers[i] = {integer(points[i][0]), integer(points[i][1])};
  return integers;
}

Vector<mpz_class> difference(const Vector<mpz_class>& p, const Vector<mpz_class>& q) {
  return {p.x - q.x, p.y - q.y};
}

Sign exact_orientation(Point2 a, Point2 b, Point2 c) {
  const auto points = to_integers(std::array{a, b, c});
  return sign_of(sgn(cross(difference(points[0], points[2]), difference(points[1], points[2]))));
}

Sign exact_opposite_angles(Point2 a, Point2 b, Point2 u, Point2 v) {
  const auto points = to_integers(std::array{a, b, u, v});
  const Vector<mpz_class> au = difference(points[2], points[0]), av = difference(points[3], points[0]);
  const Vector<mpz_class> bu = difference(points[2], points[1]), bv = difference(points[3], points[1]);
  const mpz_class value = cross(au, av) * dot(bv, bu) + dot(au, av) * cross(bv, bu);
  return sign_of(sgn(value));
}

}  // namespace

Sign orientation(Point2 a, Point2 b, Point2 c) {
  const auto certain = filtered_orientation(a, b, c);
  return certain ? *certain : exact_orientation(a, b, c);
}

Sign opposite_angles(Point2 a, Point2 b, Point2 u, Point2 v) {
  const auto certain = filtered_opposite_angles(a, b, u, v);
  return certain ? *certain : exact_opposite_angles(a, b, u, v);
}

Sign enclosed_area(std::span<const std::array<Point2, 2>> edges) {
  // Summed over rationals, whose denominators are powers of two, since the scales of the edges differ.
  mpq_class twice_area = 0;
  for (const auto& [from, to] : edges)
    twice_area += mpq_class(from[0]) * mpq_class(to[1]) - mpq_class(from[1]) * mpq_class(to[0]);
  return sign_of(sgn(twice_area));
}

}  // namespace tribunal::verify
