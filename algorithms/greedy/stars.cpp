#include "algorithms/greedy/stars.hpp"

#include "algorithms/greedy/radial_order.hpp"

#include <algorithm>
#include <utility>

namespace tribunal {

Stars::Stars(const PlanarProblem& problem) : problem_(problem), local_(problem.points.size(), none) {
  require_pool(problem);
  for (Index i = 0; i < problem.sites.size(); ++i) local_[problem.sites[i]] = i;
  stars_.reserve(problem.sites.size());
  for (const Index site : problem.sites) stars_.push_back(star_of(site));
}

Stars::Star Stars::star_of(Index site) const {
  const auto& p = problem_.points;
  std::vector<Index> seen;
  for (const Index other : problem_.sites)
    if (other != site) seen.push_back(other);
  const RadialOrder order(problem_, site);
  // Sites of one direction all lie before or all behind the centre, where they are ordered from it outwards.
  std::sort(seen.begin(), seen.end(), [&](Index a, Index b) {
    const bool a_behind = p[a] < p[site], b_behind = p[b] < p[site];
    if (a_behind != b_behind) return b_behind;
    return a_behind ? p[b] < p[a] : p[a] < p[b];
  });
  std::stable_sort(seen.begin(), seen.end(), order);

  Star star;
  star.direction.resize(problem_.sites.size(), none);
  star.hidden.resize(problem_.sites.size(), false);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool in_line = i > 0 && order.same_direction(seen[i - 1], seen[i]);
    if (!in_line) ++star.directions;
    star.direction[local_[seen[i]]] = star.directions - 1;
    star.hidden[local_[seen[i]]] = in_line;
  }
  star.closest.resize(2 * std::size_t{star.directions}, none);
  return star;
}

bool Stars::conflicts(const Edge& segment) {
  const Star& star = stars_[local_[segment[0]]];
  const Index seen = local_[segment[1]];
  if (star.hidden[seen]) return true;
  for (Index node = star.direction[seen] + star.directions; node > 0; node /= 2) {
    ++steps_;
    if (star.closest[node] != none && separates(star.closest[node], segment[0], segment[1])) return true;
  }
  return false;
}

void Stars::insert(const Edge& segment) {
  const auto edge = static_cast<Index>(edges_.size());
  edges_.push_back(segment);
  for (const Index site : problem_.sites) {
    if (site == segment[0] || site == segment[1]) continue;
    const Sign turn = side(edge, site);
    if (turn == Sign::positive) hide_between(site, segment[0], segment[1], edge);
    if (turn == Sign::negative) hide_between(site, segment[1], segment[0], edge);
  }
}

/// Hides what the site sees counter-clockwise from `right` to `left`, both excluded.
void Stars::hide_between(Index site, Index right, Index left, Index edge) {
  const Star& star = stars_[local_[site]];
  const Index first = star.direction[local_[right]] + 1, last = star.direction[local_[left]];
  if (first <= last) {
    hide_range(site, first, last, edge);
  } else {
    hide_range(site, first, star.directions, edge);
    hide_range(site, 0, last, edge);
  }
}

/// Offers the edge to the nodes that make up the directions in [first, last).
void Stars::hide_range(Index site, Index first, Index last, Index edge) {
  Star& star = stars_[local_[site]];
  const auto offer = [&](Index node) {
    ++steps_;
    Index& closest = star.closest[node];
    if (closest == none || is_closer(edge, closest, site)) closest = edge;
  };
  first += star.directions;
  last += star.directions;
  for (; first < last; first /= 2, last /= 2) {
    if (first % 2 == 1) offer(first++);
    if (last % 2 == 1) offer(--last);
  }
}

/// Of two edges that do not cross and that one ray from the site meets: whether the ray meets `edge` first.
/// The line of one of them has the other on one side.
bool Stars::is_closer(Index edge, Index other, Index site) {
  ++tests_;
  const Sign front = side(edge, site);
  const Sign first = side(edge, edges_[other][0]), second = side(edge, edges_[other][1]);
  if (first != front && second != front) return true;
  if (first != -front && second != -front) return false;
  const Sign other_front = side(other, site);
  return side(other, edges_[edge][0]) != -other_front && side(other, edges_[edge][1]) != -other_front;
}

bool Stars::separates(Index edge, Index a, Index b) {
  ++tests_;
  return side(edge, a) * side(edge, b) == Sign::negative;
}

Sign Stars::side(Index edge, Index site) const {
  const auto& p = problem_.points;
  return problem_.kernel.orient2d(p[edges_[edge][0]], p[edges_[edge][1]], p[site]);
}

}  // namespace tribunal
