// Sites in counter-clockwise order around one of them.
#pragma once

#include "algorithms/algorithm.hpp"

namespace tribunal {

/// Counter-clockwise order of directions from a centre, beginning straight down, that direction excluded.
/// Exact where the kernel is: which half plane a site is in, its coordinates say.
class RadialOrder {
 public:
  RadialOrder(const PlanarProblem& problem, Index centre) : problem_(problem), centre_(centre) {}

  /// Whether the direction to p comes before that to q.
  bool operator()(Index p, Index q) const {
    if (in_first_half(p) != in_first_half(q)) return in_first_half(p);
    return turn(p, q) == Sign::positive;
  }

  bool same_direction(Index p, Index q) const {
    return in_first_half(p) == in_first_half(q) && turn(p, q) == Sign::zero;
  }

 private:
  // To the right of the centre, or straight above it.
  bool in_first_half(Index p) const { return problem_.points[centre_] < problem_.points[p]; }
  Sign turn(Index p, Index q) const {
    return problem_.kernel.orient2d(problem_.points[centre_], problem_.points[p], problem_.points[q]);
  }

  const PlanarProblem& problem_;
  Index centre_;
};

}  // namespace tribunal
