#include "datasets/queries/degenerate_integers.hpp"

#include "datasets/queries/coordinates.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tribunal::queries {
namespace {

template <int D>
using IntegerVector = std::array<std::int64_t, D>;

template <int D>
IntegerVector<D> draw_vector(Random& random, std::int64_t low, std::int64_t high) {
  IntegerVector<D> v;
  for (std::int64_t& c : v) c = integer_between(random, low, high);
  return v;
}

/// Moves a configuration whose coordinates are below 2^19 to where all are positive.
template <int D>
void translate(Random& random, std::span<Point<D>> points) {
  const IntegerVector<D> shift = draw_vector<D>(random, 1 << 19, (1 << 20) - 1);
  for (Point<D>& p : points)
    for (int axis = 0; axis < D; ++axis) p[axis] += static_cast<double>(shift[axis]);
}

template <int D>
bool are_distinct(std::span<const Point<D>> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::find(points.begin(), points.begin() + i, points[i]) != points.begin() + i) return false;
  return true;
}

/// Small integer combinations of D - 1 random vectors: on a line in the plane, on a plane in space.
template <int D>
void draw_on_plane(Random& random, std::span<Point<D>> points) {
  std::array<IntegerVector<D>, D - 1> spanning;
  for (auto& v : spanning) v = draw_vector<D>(random, -8191, 8191);
  for (Point<D>& p : points) {
    p = {};
    for (const auto& v : spanning) {
      const std::int64_t multiple = integer_between(random, -32, 32);
      for (int axis = 0; axis < D; ++axis) p[axis] += static_cast<double>(multiple * v[axis]);
    }
  }
}

struct Gaussian {
  std::int64_t re, im;
  friend Gaussian operator*(Gaussian a, Gaussian b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

/// Gaussian integers of one norm: the products of three of them, each conjugated or not, times a unit. No two
/// of the 32 are likely to coincide.
void draw_on_sphere(Random& random, std::span<Point2> points) {
  std::array<Gaussian, 3> factors;
  for (Gaussian& z : factors) z = {integer_between(random, 1, 48), integer_between(random, 1, 48)};
  for (Point2& p : points) {
    const std::array<Gaussian, 4> units{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    Gaussian z = units[random.below(units.size())];
    for (const Gaussian& factor : factors) z = z * (coin(random) ? factor : Gaussian{factor.re, -factor.im});
    p = {{static_cast<double>(z.re), static_cast<double>(z.im)}};
  }
}

/// The integer matrix v -> q v q* of a quaternion: a rotation times the norm of q (Euler, Rodrigues).
std::array<IntegerVector<3>, 3> scaled_rotation(const IntegerVector<4>& q) {
  const auto [a, b, c, d] = q;
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
           {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
           {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
}

/// Signed permutations of a random vector, all turned by one random rotation.
void draw_on_sphere(Random& random, std::span<Point3> points) {
  const auto rotation = scaled_rotation(draw_vector<4>(random, 1, 6));
  IntegerVector<3> v = draw_vector<3>(random, 1, 512);
  for (Point3& p : points) {
    random.shuffle(std::span<std::int64_t>(v));
    for (std::int64_t& c : v) c = coin(random) ? c : -c;
    for (int axis = 0; axis < 3; ++axis) {
      const auto& row = rotation[axis];
      p[axis] = static_cast<double>(row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
    }
  }
}

template <int D>
void draw_degenerate(Random& random, std::span<Point<D>> points) {
  const bool spherical = points.size() == D + 2 && random.below(8) != 0;
  do {
    spherical ? draw_on_sphere(random, points) : draw_on_plane(random, points);
  } while (!are_distinct<D>(points));
  translate(random, points);
}

}  // namespace

void draw_degenerate_integers(Predicate, Random& random, std::span<Point2> points) {
  draw_degenerate(random, points);
}

void draw_degenerate_integers(Predicate, Random& random, std::span<Point3> points) {
  draw_degenerate(random, points);
}

}  // namespace tribunal::queries
