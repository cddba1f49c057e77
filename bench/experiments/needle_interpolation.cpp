// Experiment `needle-interpolation`: the gradient of a linear interpolant on a triangle that collapses.
//
// u = x^2, interpolated at the corners of two triangles of height 2^-k, k given as `halvings`, and width h =
// 1: the flat one (-h, 0), (h, 0), (0, e) whose angle at the top goes to 180 degrees, and the needle (0, 0),
// (h, 0), (0, e), whose largest angle stays 90. Counters: `flat.error`, the error of the y component of the
// gradient on the flat one, which is h^2 / e; `flat.expected`, that; `needle.error`, the largest error of the
// needle's gradient on it, at most h; `angle`, of the flat one at the top, in degrees.
#include "bench/experiments/listed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tribunal::bench {
namespace {

constexpr Parameter halvings_parameter{.name = "halvings",
                                       .summary = "the height is 1 halved so many times",
                                       .standard = "10",
                                       .least = 0,
                                       .most = 500};
constexpr std::array parameters{halvings_parameter};

struct Corner {
  double x, y;
};
struct Gradient {
  double x, y;
};

double u(const Corner& c) { return c.x * c.x; }

/// Of the linear function through the corners, by Cramer's rule. Powers of two: nothing is rounded.
Gradient gradient(const std::array<Corner, 3>& t) {
  const double ax = t[1].x - t[0].x, ay = t[1].y - t[0].y, au = u(t[1]) - u(t[0]);
  const double bx = t[2].x - t[0].x, by = t[2].y - t[0].y, bu = u(t[2]) - u(t[0]);
  const double area = ax * by - ay * bx;
  return {(au * by - ay * bu) / area, (ax * bu - au * bx) / area};
}

Finding run_needle_interpolation(const Cell& cell) {
  const double h = 1,
               e = std::ldexp(1.0, -static_cast<int>(whole_number(cell.parameters, halvings_parameter)));
  const Gradient flat = gradient({Corner{-h, 0}, {h, 0}, {0, e}});
  const Gradient needle = gradient({Corner{0, 0}, {h, 0}, {0, e}});
  // The exact gradient (2x, 0) runs from 0 to 2h over the needle.
  const double needle_error = std::max(std::abs(needle.x), std::abs(2 * h - needle.x)) + std::abs(needle.y);
  return {.counters = {{"flat.error", std::abs(flat.y)},
                       {"flat.expected", h * h / e},
                       {"needle.error", needle_error},
                       {"angle", 2 * std::atan2(h, e) * 180 / std::numbers::pi}}};
}

}  // namespace

constinit const Experiment needle_interpolation_experiment{
    .name = "needle-interpolation",
    .cites = "Babuska and Aziz 1976; Barth, section 3.4",
    .summary = "gradients of linear interpolants: large angles spoil them, small ones do not",
    .reads = {},
    .parameters = parameters,
    .run = run_needle_interpolation,
};

}  // namespace tribunal::bench
