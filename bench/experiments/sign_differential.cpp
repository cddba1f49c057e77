// Experiment `sign-differential`: how often a backend's sign is wrong, over random queries of a stated kind.
//
// n random queries to one predicate, against exact integers. Coordinates are integers in [-2^(bits-1),
// 2^(bits-1)), or with bits = 0 such integers of 53 bits times 2^-53. Generators:
// - `uniform`: all coordinates uniform;
// - `near-cancelling`: the determinant is zero or next to it. orient2d: a, b = a + m v and c = a + k v, or c
//   off the line by the least that the lattice has, so that the determinant is 0 or +-m gcd(v). incircle:
//   four of the eight images of (x, y) under the symmetries of the square about a random centre, the last
//   moved by -1, 0 or 1 in x and y;
// - `grid`: random nodes of an 8 x 8 grid spanned by random vectors (a, b) and (-b, a): many exact zeros, at
//   full length.
//
// Counters: `queries`, `zeros` (exact), `wrong` = `false_zero` + `inverted` + `false_nonzero`, and
// `stage.*`, the queries decided by each stage, 0 included.
#include "bench/experiments/listed.hpp"
#include "bench/experiments/sign_errors.hpp"
#include "bench/input.hpp"
#include "datasets/random.hpp"
#include "predicates/backends/list.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr Parameter predicate_parameter{
    .name = "predicate", .summary = "the predicate asked", .standard = "orient2d", .choices = [] {
      return std::vector<std::string_view>{"orient2d", "incircle"};
    }};
constexpr Parameter generator_parameter{
    .name = "generator", .summary = "how the queries are drawn", .standard = "uniform", .choices = [] {
      return std::vector<std::string_view>{"uniform", "near-cancelling", "grid"};
    }};
constexpr std::array parameters{predicate_parameter, generator_parameter};

constexpr int least_bits = 7;  // room for the grid's 7 steps in two directions and for the moves by one

/// The vector w with det(v, w) = gcd(v) > 0, the least there is, and |w| <= |v| / 2 in each coordinate, by
/// Euclid's extended algorithm (for gcd(v) = |v_x| or |v_y| a coordinate of w can be 1).
Point2 smallest_turn(const Point2& v) {
  auto p = static_cast<std::int64_t>(std::abs(v[0])), q = static_cast<std::int64_t>(std::abs(v[1]));
  std::int64_t x = 1, y = 0, next_x = 0, next_y = 1;  // p = x |v_x| + y |v_y|, and q likewise
  while (q != 0) {
    const std::int64_t quotient = p / q;
    p = std::exchange(q, p - quotient * q);
    x = std::exchange(next_x, x - quotient * next_x);
    y = std::exchange(next_y, y - quotient * next_y);
  }
  return {v[1] < 0 ? static_cast<double>(y) : -static_cast<double>(y),
          v[0] < 0 ? -static_cast<double>(x) : static_cast<double>(x)};
}

/// Draws the four points of one query (orient2d uses three) as integers of absolute value at most `half`,
/// 2^(bits-1).
class Generator {
 public:
  using Query = std::array<Point2, 4>;

  Generator(std::uint64_t seed, int bits) : random_(seed), half_(std::ldexp(1.0, bits - 1)) {}

  Query uniform() { return {anywhere(), anywhere(), anywhere(), anywhere()}; }

  Query near_line() {
    const Point2 a = within(half_ / 8), v = within(half_ / 8);
    const auto m = static_cast<double>(2 + random_.below(6));
    const auto k = static_cast<double>(1 + random_.below(static_cast<std::uint64_t>(m) - 1));
    const Point2 turn = random_.below(2) == 0 ? Point2{0, 0} : smallest_turn(v);
    const Point2 b{a[0] + m * v[0], a[1] + m * v[1]};
    const Point2 c{a[0] + k * v[0] + turn[0], a[1] + k * v[1] + turn[1]};
    return random_.below(2) == 0 ? Query{a, b, c, a} : Query{b, a, c, a};
  }

  Query near_circle() {
    const Point2 m = within(half_ / 2 - 1), v = within(half_ / 2);
    std::array<Point2, 8> images{{{v[0], v[1]},
                                  {-v[1], v[0]},
                                  {-v[0], -v[1]},
                                  {v[1], -v[0]},
                                  {v[1], v[0]},
                                  {-v[0], v[1]},
                                  {-v[1], -v[0]},
                                  {v[0], -v[1]}}};
    random_.shuffle(std::span<Point2>(images));
    for (Point2& p : images) p = {m[0] + p[0], m[1] + p[1]};
    return {images[0], images[1], images[2], moved(images[3])};
  }

  Query grid() {
    const Point2 origin = within(half_ / 8), step = within(half_ / 16);
    const auto node = [&] {
      const auto i = static_cast<double>(random_.below(8)), j = static_cast<double>(random_.below(8));
      return Point2{origin[0] + step[0] * i - step[1] * j, origin[1] + step[1] * i + step[0] * j};
    };
    return {node(), node(), node(), node()};
  }

 private:
  /// Uniform on the integers of [-bound, bound).
  double integer(double bound) {
    const auto whole = static_cast<std::uint64_t>(bound);
    return static_cast<double>(random_.below(2 * whole)) - static_cast<double>(whole);
  }
  Point2 within(double bound) {
    const double x = integer(bound);
    return {x, integer(bound)};
  }
  Point2 anywhere() { return within(half_); }
  Point2 moved(const Point2& p) {
    const auto x = static_cast<double>(random_.below(3));
    return {p[0] + x - 1, p[1] + static_cast<double>(random_.below(3)) - 1};
  }

  Random random_;
  double half_;
};

std::vector<Point2> draw_queries(const Cell& cell, bool incircle) {
  const std::string kind = choice(cell.parameters, generator_parameter);
  Generator generator(cell.seed, cell.bits == 0 ? 53 : cell.bits);
  const double unit = cell.bits == 0 ? 0x1p-53 : 1;
  std::vector<Point2> points;
  for (std::uint64_t i = 0; i < cell.n; ++i) {
    const Generator::Query query = kind == "uniform" ? generator.uniform()
                                   : kind == "grid"  ? generator.grid()
                                   : incircle        ? generator.near_circle()
                                                     : generator.near_line();
    for (const Point2& p : query) points.push_back({p[0] * unit, p[1] * unit});
  }
  return points;
}

Decision decide(const Kernel2& kernel, const Point2* p, bool incircle) {
  return incircle ? kernel.decide_incircle(p[0], p[1], p[2], p[3]) : kernel.decide_orient2d(p[0], p[1], p[2]);
}

Finding run_sign_differential(const Cell& cell) {
  if (cell.bits != 0 && cell.bits < least_bits)
    return {Outcome::refused_input, "bits is 0 or at least " + std::to_string(least_bits)};
  const bool incircle = choice(cell.parameters, predicate_parameter) == "incircle";
  const std::vector<Point2> points = draw_queries(cell, incircle);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const auto exact_binding = find_backend("gmp")->bind2(points);
  const Kernel2& oracle = *std::get<0>(exact_binding);

  Finding finding;
  SignErrors errors;
  double zeros = 0;
  for (const std::string_view stage : stage_names) finding.counters["stage." + std::string(stage)] = 0;
  for (std::size_t i = 0; i < points.size(); i += 4) {
    const Decision got = decide(kernel, &points[i], incircle);
    const Sign exact = decide(oracle, &points[i], incircle).sign;
    errors.note(got.sign, exact);
    zeros += exact == Sign::zero;
    ++finding.counters["stage." + std::string(to_string(got.stage))];
  }
  finding.counters["queries"] = static_cast<double>(cell.n);
  finding.counters["zeros"] = zeros;
  errors.add_to(finding.counters);
  return finding;
}

}  // namespace

constinit const Experiment sign_differential_experiment{
    .name = "sign-differential",
    .cites = "this project",
    .summary = "wrong signs of a backend over n random queries of a stated generator, against exact integers",
    .reads = {.backend = true, .n = true, .bits = true, .seed = true},
    .parameters = parameters,
    .run = run_sign_differential,
};

}  // namespace tribunal::bench
