// The triangle that every insertion algorithm starts from.
#pragma once

#include "algorithms/algorithm.hpp"

#include <utility>

namespace tribunal {

/// The first three sites, counter-clockwise. They are not collinear (see PlanarProblem).
inline Triangle first_triangle(const PlanarProblem& problem) {
  Triangle t{problem.sites[0], problem.sites[1], problem.sites[2]};
  const auto& p = problem.points;
  if (problem.kernel.orient2d(p[t[0]], p[t[1]], p[t[2]]) == Sign::negative) std::swap(t[1], t[2]);
  return t;
}

/// What the first triangle and its three ghosts contribute to the counters, the same for every insertion
/// algorithm.
inline Counters first_counters() {
  Counters counters;
  counters.tau = 1;
  counters.tau_with_ghosts = 3;  // the third site touches the triangle and two ghosts
  counters.created = 4;
  counters.outside_hull = 1;
  return counters;
}

}  // namespace tribunal
