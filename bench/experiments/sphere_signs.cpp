// Experiment `sphere-signs`: the sign table of Barth's InSphere determinant, and circles as planes of the
// paraboloid.
//
// n random integer sets in [0, 2^bits)^D. In space: five points; the truth is whether the distance of the
// fifth from the circumcentre of the first four, a vector of rational numbers, is less than the radius. In
// the plane: four points, half of them cocircular by construction; the truth is the orientation of their
// images on z = x^2 + y^2, by the backend too.
//
// Counters: `queries`; in space `inside`, `on`, `outside` (of sets with D = det(1,2,3,4) != 0), `wrong` (of
// the backend's insphere times sign D), and `printed.inside.positive` and `printed.inside.negative`: sets
// inside where the determinant as printed (rows x, y, z, x^2+y^2+z^2, 1) is positive or negative while D > 0.
// In the plane `cocircular`, and `wrong`, where incircle is not minus the orientation of the lifted points.
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/random.hpp"

#include <gmpxx.h>

#include <array>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr Parameter space_parameter{.name = "space",
                                    .summary = "three dimensions, or the plane and its paraboloid",
                                    .standard = "space",
                                    .choices = [] {
                                      return std::vector<std::string_view>{"space", "plane"};
                                    }};
constexpr std::array parameters{space_parameter};

using Rows = std::vector<std::vector<mpz_class>>;

/// By expansion along the first row: five rows make 120 products.
mpz_class determinant(const Rows& m) {
  if (m.size() == 1) return m[0][0];
  mpz_class sum = 0;
  for (std::size_t column = 0; column < m.size(); ++column) {
    Rows minor;
    for (std::size_t row = 1; row < m.size(); ++row) {
      minor.push_back(m[row]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
    }
    const mpz_class term = m[0][column] * determinant(minor);
    if (column % 2 == 0)
      sum += term;
    else
      sum -= term;
  }
  return sum;
}

std::vector<mpz_class> row_of(const Point3& p, bool lifted) {
  const mpz_class x = p[0], y = p[1], z = p[2];
  std::vector<mpz_class> row{x, y, z};
  if (lifted) row.push_back(x * x + y * y + z * z);
  row.push_back(1);
  return row;
}

/// The solution of 2 (p_i - p_0) . c = |p_i|^2 - |p_0|^2, i = 1, 2, 3; the points are not coplanar.
std::array<mpq_class, 3> circumcentre(const Point3* p) {
  Rows system;
  std::vector<mpz_class> right;
  for (int i = 1; i <= 3; ++i) {
    std::vector<mpz_class> row;
    mpz_class squares = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const mpz_class x = p[i][axis], origin = p[0][axis];
      row.push_back(2 * (x - origin));
      squares += x * x - origin * origin;
    }
    system.push_back(row);
    right.push_back(squares);
  }
  const mpz_class denominator = determinant(system);
  std::array<mpq_class, 3> centre;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Rows replaced = system;
    for (std::size_t i = 0; i < 3; ++i) replaced[i][axis] = right[i];
    centre[axis] = mpq_class(determinant(replaced), denominator);
    centre[axis].canonicalize();
  }
  return centre;
}

mpq_class squared_distance(const std::array<mpq_class, 3>& centre, const Point3& p) {
  mpq_class sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const mpq_class d = centre[axis] - p[axis];
    sum += d * d;
  }
  return sum;
}

template <int D>
Point<D> draw_point(Random& random, int bits) {
  Point<D> p{};
  for (double& c : p.coordinate) c = static_cast<double>(random.below(std::uint64_t{1} << bits));
  return p;
}

Finding run_in_space(const Cell& cell) {
  Random random(cell.seed);
  std::vector<Point3> points;
  for (std::uint64_t i = 0; i < 5 * cell.n; ++i) points.push_back(draw_point<3>(random, cell.bits));
  const Kernel3Binding binding = cell_kernel3(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel3& kernel = *std::get<0>(binding);

  Finding finding;
  auto& counters = finding.counters;
  for (const char* name :
       {"inside", "on", "outside", "wrong", "printed.inside.positive", "printed.inside.negative"})
    counters[name] = 0;
  counters["queries"] = static_cast<double>(cell.n);
  for (std::size_t i = 0; i < points.size(); i += 5) {
    const Point3* p = &points[i];
    const Sign orientation = kernel.orient3d(p[0], p[1], p[2], p[3]);
    if (orientation == Sign::zero) continue;
    const auto centre = circumcentre(p);
    const auto truth =
        static_cast<Sign>(-sgn(mpq_class(squared_distance(centre, p[4]) - squared_distance(centre, p[0]))));
    ++counters[truth == Sign::positive ? "inside" : truth == Sign::zero ? "on" : "outside"];
    counters["wrong"] += kernel.insphere(p[0], p[1], p[2], p[3], p[4]) * orientation != truth;
    if (truth != Sign::positive || orientation != Sign::positive) continue;
    Rows printed;
    for (int k = 0; k < 5; ++k) printed.push_back(row_of(p[k], true));
    ++counters[determinant(printed) > 0 ? "printed.inside.positive" : "printed.inside.negative"];
  }
  return finding;
}

/// Four points; every other time the corners of a rectangle, which lie on a circle.
std::array<Point2, 4> draw_quadruple(Random& random, int bits, bool cocircular) {
  const auto half = static_cast<double>(std::uint64_t{1} << (bits - 1));
  Point2 a = draw_point<2>(random, bits - 1), b = draw_point<2>(random, bits - 1);
  if (!cocircular) return {a, b, draw_point<2>(random, bits), draw_point<2>(random, bits)};
  // The images of a vector under quarter turns about the middle of the square.
  const double x = a[0], y = a[1];
  return {{{{half + x, half + y}}, {{half - y, half + x}}, {{half - x, half - y}}, {{half + y, half - x}}}};
}

Finding run_in_plane(const Cell& cell) {
  if (cell.bits < 2 || cell.bits > 25)
    return {Outcome::refused_input, "bits is 2 to 25: squares are doubles"};
  Random random(cell.seed);
  std::vector<Point2> flat;
  std::vector<Point3> lifted;
  for (std::uint64_t i = 0; i < cell.n; ++i)
    for (const Point2& p : draw_quadruple(random, cell.bits, i % 2 == 0)) {
      flat.push_back(p);
      lifted.push_back({{p[0], p[1], p[0] * p[0] + p[1] * p[1]}});
    }
  const Kernel2Binding planar = cell_kernel(flat, cell);
  const Kernel3Binding spatial = cell_kernel3(lifted, cell);
  if (const auto* refusal = std::get_if<Refusal>(&planar))
    return {Outcome::out_of_domain, describe(*refusal)};
  if (const auto* refusal = std::get_if<Refusal>(&spatial))
    return {Outcome::out_of_domain, describe(*refusal)};
  double cocircular = 0, wrong = 0;
  for (std::size_t i = 0; i < flat.size(); i += 4) {
    const Sign circle = std::get<0>(planar)->incircle(flat[i], flat[i + 1], flat[i + 2], flat[i + 3]);
    const Sign plane = std::get<0>(spatial)->orient3d(lifted[i], lifted[i + 1], lifted[i + 2], lifted[i + 3]);
    cocircular += circle == Sign::zero;
    wrong += circle != -plane;
  }
  return {
      .counters = {{"queries", static_cast<double>(cell.n)}, {"cocircular", cocircular}, {"wrong", wrong}}};
}

Finding run_sphere_signs(const Cell& cell) {
  if (cell.bits < 2 || cell.bits > 52) return {Outcome::refused_input, "bits is 2 to 52"};
  return choice(cell.parameters, space_parameter) == "plane" ? run_in_plane(cell) : run_in_space(cell);
}

}  // namespace

constinit const Experiment sphere_signs_experiment{
    .name = "sphere-signs",
    .cites = "Barth, section 3.7",
    .summary =
        "the sign table of the in-sphere determinant against rational circumcentres, and lifted circles",
    .reads = {.backend = true, .n = true, .bits = true, .seed = true},
    .parameters = parameters,
    .run = run_sphere_signs,
};

}  // namespace tribunal::bench
