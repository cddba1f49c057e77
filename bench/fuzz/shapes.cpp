#include "bench/fuzz/shapes.hpp"

#include <array>
#include <cstdint>

namespace tribunal::bench::fuzz {
namespace {

/// Up to three coordinates; in the plane the third stays zero.
using Vector = std::array<std::int64_t, 3>;

std::int64_t half_of(int bits) { return std::int64_t{1} << (bits - 1); }

/// Uniform on {-most, ..., most}.
std::int64_t within(Random& random, std::int64_t most) {
  return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(2 * most + 1))) - most;
}

Vector vector_within(Random& random, int dimension, std::int64_t most) {
  Vector v{};
  for (int axis = 0; axis < dimension; ++axis) v[axis] = within(random, most);
  return v;
}

void add_multiple(Vector& sum, std::int64_t factor, const Vector& v) {
  for (int axis = 0; axis < 3; ++axis) sum[axis] += factor * v[axis];
}

void put(Case& asked, int i, const Vector& v) {
  for (int axis = 0; axis < asked.dimension(); ++axis) asked.point(i)[axis] = static_cast<double>(v[axis]);
}

void anywhere(Random& random, int bits, Case& asked) {
  for (int i = 0; i < asked.points(); ++i)
    put(asked, i, vector_within(random, asked.dimension(), half_of(bits) - 1));
}

/// Nodes of a grid of two to five levels per axis, as wide as the box.
void grid(Random& random, int bits, Case& asked) {
  const auto levels = 2 + random.below(4);
  const std::int64_t step = (2 * half_of(bits) - 1) / static_cast<std::int64_t>(levels - 1);
  for (double& c : asked.numbers())
    c = static_cast<double>(static_cast<std::int64_t>(random.below(levels)) * step - half_of(bits));
}

/// Nodes of a square grid turned about the third axis: cocircular and collinear as an upright one, with
/// coordinates that share nothing.
void tilted_grid(Random& random, int bits, Case& asked) {
  const std::int64_t most = half_of(bits) / 8;  // three steps in two directions
  const Vector u{within(random, most), within(random, most), 0}, v{-u[1], u[0], 0},
      w{0, 0, within(random, most)};
  for (int i = 0; i < asked.points(); ++i) {
    Vector p{};
    for (const Vector& direction : {u, v, w}) add_multiple(p, within(random, 3), direction);
    put(asked, i, p);
  }
}

/// On one line, or on one plane in space, with small multiples of the directions.
void flat(Random& random, int bits, Case& asked) {
  const int dimension = asked.dimension();
  const std::int64_t most = half_of(bits) / 8;
  const Vector origin = vector_within(random, dimension, most), u = vector_within(random, dimension, most);
  const Vector v = dimension == 3 && random.below(8) != 0 ? vector_within(random, 3, most) : Vector{};
  for (int i = 0; i < asked.points(); ++i) {
    Vector p = origin;
    add_multiple(p, within(random, 3), u);
    add_multiple(p, within(random, 3), v);
    put(asked, i, p);
  }
}

/// Gaussian integers of one norm: z w and z conj(w), times units, conjugated or not.
Vector on_circle(Random& random, const Vector& z, const Vector& w) {
  const std::int64_t sign = random.below(2) == 0 ? 1 : -1;
  Vector p{z[0] * w[0] - sign * z[1] * w[1], sign * z[0] * w[1] + z[1] * w[0], 0};
  if (random.below(2) == 0) p = {p[1], p[0], 0};
  if (random.below(2) == 0) p[0] = -p[0];
  if (random.below(2) == 0) p[1] = -p[1];
  return p;
}

/// Integer vectors of length a^2 + b^2 + c^2 + d^2 for one quadruple in any order (Lebesgue): the
/// parametrised Pythagorean quadruples; and signed permutations of each.
Vector on_sphere(Random& random, std::array<std::int64_t, 4> q) {
  random.shuffle(std::span<std::int64_t>(q));
  const auto [a, b, c, d] = q;
  Vector p{a * a + b * b - c * c - d * d, 2 * (a * d + b * c), 2 * (b * d - a * c)};
  random.shuffle(std::span<std::int64_t>(p));
  for (std::int64_t& x : p)
    if (random.below(2) == 0) x = -x;
  return p;
}

/// On one circle or sphere around an integer centre.
void sphere(Random& random, int bits, Case& asked) {
  const std::int64_t half = half_of(bits);
  // The root of an eighth of the box, rounded down to a power of two: its quadratic forms stay in half the
  // box.
  const std::int64_t root = std::int64_t{1} << ((bits - 4) / 2);
  const Vector centre = vector_within(random, asked.dimension(), half / 2 - 1);
  const Vector z = vector_within(random, 2, root), w = vector_within(random, 2, root);
  for (int i = 0; i < asked.points(); ++i) {
    Vector p = asked.dimension() == 2 ? on_circle(random, z, w) : on_sphere(random, {z[0], z[1], w[0], w[1]});
    add_multiple(p, 1, centre);
    put(asked, i, p);
  }
}

/// All coordinates from a few values: axis-parallel lines and planes, equal points, equal differences.
void shared_coordinates(Random& random, int bits, Case& asked) {
  std::array<double, 3> values{};
  for (double& value : values) value = static_cast<double>(within(random, half_of(bits) - 1));
  for (double& c : asked.numbers()) c = values[random.below(values.size())];
}

/// Any points, one or two of them copies of others.
void repeated_points(Random& random, int bits, Case& asked) {
  random.below(2) == 0 ? anywhere(random, bits, asked) : sphere(random, bits, asked);
  const auto points = static_cast<std::uint64_t>(asked.points());
  for (auto copies = 1 + random.below(2); copies > 0; --copies) {
    const auto from = static_cast<int>(random.below(points)), to = static_cast<int>(random.below(points));
    asked.copy_point(from, to);
  }
}

constexpr std::array all{
    Shape{"anywhere", "uniform in the box", anywhere},
    Shape{"grid", "nodes of a grid of two to five levels", grid},
    Shape{"tilted-grid", "nodes of a turned square grid", tilted_grid},
    Shape{"flat", "on one line or plane", flat},
    Shape{"sphere", "on one circle or sphere", sphere},
    Shape{"shared-coordinates", "all coordinates from three values", shared_coordinates},
    Shape{"repeated-points", "some points equal", repeated_points},
};

}  // namespace

std::span<const Shape> shapes() { return all; }

}  // namespace tribunal::bench::fuzz
