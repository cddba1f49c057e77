#include "algorithms/greedy/domain.hpp"

#include "algorithms/greedy/radial_order.hpp"

#include <algorithm>

namespace tribunal {

Domain::Domain(const GreedyProblem& problem) : problem_(problem.planar) {
  spokes_.reserve(2 * problem.boundary.size());
  for (const Edge& edge : problem.boundary) {
    spokes_.push_back({edge[0], edge[1], true});
    spokes_.push_back({edge[1], edge[0], false});
  }
  // A boundary that runs both ways has two spokes in one direction: the one that leads away comes last, for
  // it is what lies counter-clockwise of them.
  std::stable_sort(spokes_.begin(), spokes_.end(), [&](const Spoke& a, const Spoke& b) {
    if (a.vertex != b.vertex) return a.vertex < b.vertex;
    if (a.end != b.end) return RadialOrder(problem_, a.vertex)(a.end, b.end);
    return a.leads_away < b.leads_away;
  });
}

bool Domain::opens_after(Index vertex, Index site) const {
  const auto first = std::lower_bound(spokes_.begin(), spokes_.end(), vertex,
                                      [](const Spoke& spoke, Index v) { return spoke.vertex < v; });
  const auto last = std::upper_bound(first, spokes_.end(), vertex,
                                     [](Index v, const Spoke& spoke) { return v < spoke.vertex; });
  if (first == last) return true;
  const RadialOrder before(problem_, vertex);
  const auto beyond =
      std::upper_bound(first, last, site, [&](Index s, const Spoke& spoke) { return before(s, spoke.end); });
  return (beyond == first ? last : beyond)[-1].leads_away;
}

}  // namespace tribunal
