// Experiment `data-error`: how well data-dependent triangulations interpolate a function that is known.
//
// The corners of the unit square and n - 4 random points, with the values of one of Franke's functions. The
// Delaunay triangulation is flipped as the parameters say, and both surfaces are compared with the function
// on the points of a 50 x 50 grid, cell centres of the square.
//
// Counters: `runs` (1); `delaunay.rms`, `delaunay.max`, `rms`, `max` (errors); `delaunay.roughness`,
// `roughness` (the sum of costs before and after); `delaunay.contour_spread`, `contour_spread` (degrees that
// contours turn away from the diagonal off the hull, root mean square by length: F2 has all on it), and with
// the hull `delaunay.contour_spread_in_all`, `contour_spread_in_all`; `flips`, `sweeps`, `tests`; `improving`
// (flips that would still make the sum smaller); `valid`.
#include "algorithms/data_dependent/optimize.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/franke_data.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr std::array parameters{function_parameter, cost_parameter, norm_parameter, search_parameter,
                                flip_seed_parameter};

struct Errors {
  double rms = 0, max = 0;
};

/// Each grid point counts in the first triangle that holds it, by rounded coordinates: it is an error, not a
/// decision.
Errors errors_on_grid(const std::vector<Point2>& points, const std::vector<double>& data,
                      const std::vector<Triangle>& triangles, double (*function)(const Point2&)) {
  constexpr int side = 50;
  std::array<bool, side * side> seen{};
  Errors errors;
  for (const Triangle& t : triangles) {
    const Point2 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [low, high] = std::minmax({a[1], b[1], c[1]});
    const auto first = [](double x) { return std::max(0, static_cast<int>(std::floor(x * side - 0.5))); };
    for (int i = first(left); i < side && (i + 0.5) / side <= right; ++i)
      for (int j = first(low); j < side && (j + 0.5) / side <= high; ++j) {
        const Point2 p{(i + 0.5) / side, (j + 0.5) / side};
        const double u = ((p[0] - a[0]) * (c[1] - a[1]) - (p[1] - a[1]) * (c[0] - a[0])) / area;
        const double v = ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / area;
        if (u < 0 || v < 0 || u + v > 1 || seen[i * side + j]) continue;
        seen[i * side + j] = true;
        const double value = data[t[0]] + u * (data[t[1]] - data[t[0]]) + v * (data[t[2]] - data[t[0]]);
        const double error = std::fabs(value - function(p));
        errors.rms += error * error;
        errors.max = std::max(errors.max, error);
      }
  }
  const auto count = std::count(seen.begin(), seen.end(), true);
  errors.rms = std::sqrt(errors.rms / static_cast<double>(std::max<std::ptrdiff_t>(count, 1)));
  return errors;
}

/// How far the contours of the surface turn away from 45 degrees, in degrees: root mean square, weighted by
/// their length. All contours of a triangle have one direction, and their length over all levels is the
/// gradient's times the triangle's area. Off the hull: over triangles without an edge of it. Those edges, a
/// side of the square long, stay whatever is flipped, and the needles on them have contours of nearly their
/// own direction.
enum class Over { all, off_hull };
double contour_spread(const std::vector<Point2>& points, const std::vector<double>& data,
                      const EdgeMesh& mesh, Over over) {
  double squares = 0, length = 0;
  for (HalfEdge h = 0; h < 2 * mesh.edges(); ++h) {
    const HalfEdge n = mesh.next(h), p = mesh.prev(h);
    if (mesh.is_outer(h) || h > n || h > p) continue;  // each triangle once
    const bool on_hull = !mesh.is_inner(h / 2) || !mesh.is_inner(n / 2) || !mesh.is_inner(p / 2);
    if (on_hull && over == Over::off_hull) continue;
    const Triangle t{mesh.from(h), mesh.from(n), mesh.from(p)};
    const Point2 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    // The gradient times twice the area, turned by a right angle: along the contours.
    const double f = data[t[1]] - data[t[0]], g = data[t[2]] - data[t[0]];
    const double x = f * (c[0] - a[0]) - g * (b[0] - a[0]), y = f * (c[1] - a[1]) - g * (b[1] - a[1]);
    const double weight = std::hypot(x, y);
    if (weight == 0) continue;
    double away = std::atan2(y, x) * 180 / std::numbers::pi - 45;
    away -= 180 * std::round(away / 180);
    squares += weight * away * away;
    length += weight;
  }
  return length > 0 ? std::sqrt(squares / length) : 0;
}

double count_improving(const RoughMesh& rough) {
  double improving = 0;
  for (Index edge = 0; edge < rough.mesh.edges(); ++edge)
    improving += rough.is_flippable(edge) && rough.roughness.change_by_flip(rough.mesh, edge).is_better();
  return improving;
}

Finding run_data_error(const Cell& cell) {
  if (cell.n < 4 || cell.n > 100'000) return {Outcome::refused_input, "n is 4 to 100000"};
  const std::vector<Point2> points = corners_and_random_points(cell.n, cell.seed);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const Triangulation delaunay = delaunay_of(points, kernel);
  if (delaunay.outcome != Outcome::ok) return {delaunay.outcome, delaunay.reason};

  const FrankeFunction& function = chosen_function(cell);
  const std::vector<double> data = sample(function, points);
  const Sites sites{points, kernel};
  const Roughness roughness = chosen_roughness(points, data, cell.parameters);
  EdgeMesh mesh(delaunay.triangles);
  const double before = roughness.total(mesh);
  const FlipCounts counts = flip_for_data(sites, mesh, data, cell.parameters);
  const std::vector<Triangle> triangles = mesh.triangles();
  const EdgeMesh unflipped(delaunay.triangles);
  const Errors first = errors_on_grid(points, data, delaunay.triangles, function.value);
  const Errors last = errors_on_grid(points, data, triangles, function.value);
  const auto verdict = verify::verify_planar(points, {.triangles = triangles},
                                             {.kind = verify::Kind::triangulation, .max_faults = 1});
  return {.counters = {{"runs", 1},
                       {"delaunay.rms", first.rms},
                       {"delaunay.max", first.max},
                       {"rms", last.rms},
                       {"max", last.max},
                       {"delaunay.roughness", before},
                       {"roughness", roughness.total(mesh)},
                       {"delaunay.contour_spread", contour_spread(points, data, unflipped, Over::off_hull)},
                       {"contour_spread", contour_spread(points, data, mesh, Over::off_hull)},
                       {"delaunay.contour_spread_in_all", contour_spread(points, data, unflipped, Over::all)},
                       {"contour_spread_in_all", contour_spread(points, data, mesh, Over::all)},
                       {"flips", static_cast<double>(counts.flips)},
                       {"sweeps", static_cast<double>(counts.sweeps)},
                       {"tests", static_cast<double>(counts.tests)},
                       {"improving", count_improving({sites, mesh, roughness})},
                       {"valid", verdict.valid()}}};
}

}  // namespace

constinit const Experiment data_error_experiment{
    .name = "data-error",
    .cites = "Dyn, Levin, Rippa 1990; Barth, section 3.4",
    .summary = "errors of data-dependent interpolation on a grid, beside Delaunay's",
    .reads = {.backend = true, .n = true, .seed = true},
    .parameters = parameters,
    .run = run_data_error,
};

}  // namespace tribunal::bench
