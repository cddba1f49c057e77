// An aerofoil with its flap and slat out: the NACA 4412, a copy of 0.3 chords behind and below its trailing
// edge and one of 0.15 chords before and above its leading edge, in a box of 12 chords.
//
// The copies are turned by angles with rational sines and cosines: the flap by 22.6, 28.1 or 36.9 degrees,
// the slat by 28.1. The gaps are 0.02, 0.015 or 0.01 chords, flap and main element overlap by nothing. Seeds
// 1, 2, 3 turn the flap by these angles, with the wide gap; 4, 5, 6 have the next gap and 7, 8, 9 the narrow
// one; further seeds begin anew.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/outline.hpp"
#include "datasets/shapes/pslg_points.hpp"

#include <algorithm>
#include <array>

namespace tribunal::generators {
namespace {
using namespace shapes;

constexpr FourDigit section{.camber = 0.04, .camber_at = 0.4, .thickness = 0.12, .blunt = false};
constexpr std::uint64_t far_points = 32;

struct Turn {
  double cosine, sine;
};
constexpr std::array<Turn, 3> turns{{{12.0 / 13, 5.0 / 13}, {15.0 / 17, 8.0 / 17}, {0.8, 0.6}}};
constexpr std::array<double, 3> gaps{0.02, 0.015, 0.01};

double leftmost(const Outline& outline) { return (*std::min_element(outline.begin(), outline.end()))[0]; }
double rightmost(const Outline& outline) { return (*std::max_element(outline.begin(), outline.end()))[0]; }

Outline flap_of(const Outline& main, std::uint64_t stations, const Turn& turn, double gap) {
  const Outline flap = turned(outline_of(section, stations), 0.3, turn.cosine, -turn.sine);
  return closed_up(main, moved(flap, rightmost(main) - leftmost(flap), -0.5), gap, false);
}

Outline slat_of(const Outline& main, std::uint64_t stations, double gap) {
  const Outline slat = turned(outline_of(section, stations), 0.15, turns[1].cosine, turns[1].sine);
  return closed_up(main, moved(slat, leftmost(main) - rightmost(slat), 0.5), gap, true);
}

/// In the middle between the upper and lower side, half way along the chord.
Point2 inside(const Outline& element) {
  const Point2 &upper = element[element.size() / 4], &lower = element[element.size() - element.size() / 4];
  return {{(upper[0] + lower[0]) / 2, (upper[1] + lower[1]) / 2}};
}

DatasetGraph graph(std::uint64_t n, std::uint64_t seed) {
  const std::uint64_t stations = std::max<std::uint64_t>(16, (n - std::min(n, far_points) + 7) / 8 * 2);
  const double gap = gaps[(seed + 8) / 3 % 3];
  const Outline main = outline_of(section, stations);
  DatasetGraph graph;
  for (const Outline& element :
       {main, flap_of(main, stations / 2, turns[(seed + 8) % 3], gap), slat_of(main, stations / 2, gap)}) {
    add_loop(graph, element);
    graph.holes.push_back(inside(element));
  }
  add_loop(graph, box_around(6, far_points / 4));
  return graph;
}

}  // namespace

constinit const Dataset high_lift{
    .about = {.name = "high-lift",
              .cites = "Barth, Figures 3.5.5 to 3.5.7",
              .summary = "NACA 4412 with slat and flap in a box: narrow gaps between curved walls",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n, std::uint64_t seed) { return first_points(graph(n, seed), n); },
    .graph = graph,
};

}  // namespace tribunal::generators
