// Experiment `convexity-signs`: the barycentric signs b_1, ..., b_4 of Barth (3.7.0) against geometry without
// determinants.
//
// n random five-point sets with integer coordinates in [0, 2^bits): a tetrahedron 1234 that is not flat, and
// e. The signs by Cramer's rule (determinants by the backend under trial), with and without the sign of D =
// det(1,2,3,4), are held against which side of each face e and the opposite corner lie on; and the verdict
// "1234 and 123e form a strictly convex body" against whether the segment from 4 to e pierces the open
// triangle 123, found by projecting it.
//
// Counters: `queries`; `positive` and `negative` (sign of D); `wrong`, sets where a normalised sign is wrong;
// `printed_wrong.positive` and `printed_wrong.negative`, where the signs without D are, by the sign of D;
// `convex`; `convexity_wrong`; `zeros`, sets with some b_i = 0.
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/random.hpp"
#include "predicates/arithmetic/fixed_integer.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/formulas/convexity.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr int most_bits = 12;  // the projected triangle's area then fits 128 bits

using Vector = std::array<Int128, 3>;

Vector difference(const Point3& a, const Point3& b) {
  Vector d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = static_cast<Int128>(a[i] - b[i]);
  return d;
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Int128 dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Twice the height of p over the plane of a, b, c, times the triangle's area.
Int128 height(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return dot(cross(difference(b, a), difference(c, a)), difference(p, a));
}

/// +1 where e is on the same side of the face opposite corner i as the corner, 0 on its plane, -1 beyond.
Sign side_of_face(const std::array<Point3, 4>& t, std::size_t i, const Point3& e) {
  const Point3 &a = t[(i + 1) % 4], &b = t[(i + 2) % 4], &c = t[(i + 3) % 4];
  return sign_of(height(a, b, c, e)) * sign_of(height(a, b, c, t[i]));
}

/// Whether the open segment from p to q meets the open triangle a, b, c in one point.
bool pierces(const Point3& a, const Point3& b, const Point3& c, const Point3& p, const Point3& q) {
  const Int128 above = height(a, b, c, p), below = height(a, b, c, q);
  if (sign_of(above) * sign_of(below) != Sign::negative) return false;
  // The point of intersection relative to a, times above - below.
  const Vector to_p = difference(p, a), to_q = difference(q, a);
  Vector x;
  for (std::size_t i = 0; i < 3; ++i) x[i] = above * to_q[i] - below * to_p[i];
  if (above - below < 0)
    for (Int128& coordinate : x) coordinate = -coordinate;
  const Int128 scale = above > below ? above - below : below - above;
  // Seen along an axis that the triangle is not parallel to.
  const Vector normal = cross(difference(b, a), difference(c, a));
  const std::size_t drop = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const std::size_t u = (drop + 1) % 3, v = (drop + 2) % 3;
  const Vector to_b = difference(b, a), to_c = difference(c, a);
  const Sign turn = sign_of(normal[drop]);
  const Int128 from_ab = to_b[u] * x[v] - to_b[v] * x[u];
  const Int128 from_ca = x[u] * to_c[v] - x[v] * to_c[u];
  const Int128 rest = scale * normal[drop] - from_ab - from_ca;
  return sign_of(from_ab) == turn && sign_of(from_ca) == turn && sign_of(rest) == turn;
}

std::vector<Point3> draw_sets(const Cell& cell) {
  Random random(cell.seed);
  std::vector<Point3> points;
  while (points.size() < 5 * cell.n) {
    std::array<Point3, 5> set;
    for (Point3& p : set)
      for (double& c : p.coordinate) c = static_cast<double>(random.below(std::uint64_t{1} << cell.bits));
    if (height(set[0], set[1], set[2], set[3]) != 0) points.insert(points.end(), set.begin(), set.end());
  }
  return points;
}

Finding run_convexity_signs(const Cell& cell) {
  if (cell.bits < 1 || cell.bits > most_bits) return {Outcome::refused_input, "bits is 1 to 12"};
  const std::vector<Point3> points = draw_sets(cell);
  const Kernel3Binding binding = cell_kernel3(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel3& kernel = *std::get<0>(binding);

  double positive = 0, wrong = 0, convex = 0, convexity_wrong = 0, zeros = 0;
  std::array<double, 2> printed_wrong{};
  for (std::size_t i = 0; i < points.size(); i += 5) {
    const std::array<Point3, 4> t{points[i], points[i + 1], points[i + 2], points[i + 3]};
    const Point3& e = points[i + 4];
    const auto b = barycentric_signs(kernel, t, e);
    const Sign orientation = kernel.orient3d(t[0], t[1], t[2], t[3]);
    std::array<Sign, 4> truth;
    for (std::size_t k = 0; k < 4; ++k) truth[k] = side_of_face(t, k, e);
    auto printed = b;
    for (Sign& sign : printed) sign = sign * orientation;
    positive += orientation == Sign::positive;
    wrong += b != truth;
    printed_wrong[orientation == Sign::positive] += printed != truth;
    zeros += std::find(truth.begin(), truth.end(), Sign::zero) != truth.end();
    const bool body = pierces(t[0], t[1], t[2], t[3], e);
    convex += body;
    convexity_wrong += is_strictly_convex(b) != body;
  }
  const auto queries = static_cast<double>(cell.n);
  return {.counters = {{"queries", queries},
                       {"positive", positive},
                       {"negative", queries - positive},
                       {"wrong", wrong},
                       {"printed_wrong.negative", printed_wrong[0]},
                       {"printed_wrong.positive", printed_wrong[1]},
                       {"convex", convex},
                       {"convexity_wrong", convexity_wrong},
                       {"zeros", zeros}}};
}

}  // namespace

constinit const Experiment convexity_signs_experiment{
    .name = "convexity-signs",
    .cites = "Barth, eq. (3.7.0)",
    .summary =
        "the barycentric signs of a fifth point by determinants, against which side of each face it is on",
    .reads = {.backend = true, .n = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_convexity_signs,
};

}  // namespace tribunal::bench
