// One aerofoil in a box: what the datasets `aerofoil` and `aerofoil-blunt` share.
#pragma once

#include "datasets/shapes/outline.hpp"

#include <algorithm>
#include <array>

namespace tribunal::shapes {

/// The NACA 0012, 4412, 2415 and 0008 for the seeds 1 to 4; further seeds begin anew. On the outline and on
/// a box of 12 chords, 8 steps to a side, at least n points, as few more as can be, and at least 8 stations.
inline DatasetGraph single_aerofoil(std::uint64_t n, std::uint64_t seed, bool blunt) {
  static constexpr std::array<FourDigit, 4> families{
      {{0, 0.5, 0.12, false}, {0.04, 0.4, 0.12, false}, {0.02, 0.4, 0.15, false}, {0, 0.5, 0.08, false}}};
  FourDigit section = families[(seed + 3) % 4];
  section.blunt = blunt;
  constexpr std::uint64_t far_points = 32;
  const std::uint64_t stations = std::max<std::uint64_t>(8, (n - std::min(n, far_points) + 1) / 2);
  DatasetGraph graph;
  add_loop(graph, outline_of(section, stations));
  add_loop(graph, box_around(6, far_points / 4));
  graph.holes.push_back({{0.5, section.camber}});
  return graph;
}

}  // namespace tribunal::shapes
