#include "algorithms/greedy/stars.hpp"

#include "algorithms/direction.hpp"
#include "algorithms/greedy/radial_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tribunal {
namespace {

/// Grows with a direction as it turns counter-clockwise from straight down.
double rounded_turn(Point2 centre, Point2 p) {
  const auto [x, y] = direction(centre, p);
  const double height = y / (std::fabs(x) + std::fabs(y));
  return centre < p ? height : 3 - height;
}

/// The other sites counter-clockwise, those of one direction from the centre outwards. Rounded directions are
/// nearly always in the right order, and whether they are takes few questions; exact ones take O(n log n).
std::vector<Index> sites_around(const PlanarProblem& problem, Index centre) {
  const auto& p = problem.points;
  struct Seen {
    double turn;
    Index site;
  };
  std::vector<Seen> seen;
  for (const Index other : problem.sites)
    if (other != centre) seen.push_back({rounded_turn(p[centre], p[other]), other});
  // Sites of one direction all lie before or all behind the centre, where they are ordered from it outwards.
  const auto outwards = [&](Index a, Index b) { return p[centre] < p[a] ? p[a] < p[b] : p[b] < p[a]; };
  std::sort(seen.begin(), seen.end(), [&](const Seen& a, const Seen& b) {
    return a.turn != b.turn ? a.turn < b.turn : outwards(a.site, b.site);
  });
  std::vector<Index> sites;
  sites.reserve(seen.size());
  for (const Seen& s : seen) sites.push_back(s.site);

  const RadialOrder order(problem, centre);
  const auto before = [&](Index a, Index b) {
    if (order(a, b)) return true;
    return !order(b, a) && outwards(a, b);
  };
  // Stable, since that is safe with signs that contradict each other.
  if (!std::is_sorted(sites.begin(), sites.end(), before))
    std::stable_sort(sites.begin(), sites.end(), before);
  return sites;
}

}  // namespace

Stars::Stars(const PlanarProblem& problem) : problem_(problem), local_(problem.points.size(), none) {
  require_pool(problem);
  for (Index i = 0; i < problem.sites.size(); ++i) local_[problem.sites[i]] = i;
  stars_.reserve(problem.sites.size());
  for (const Index site : problem.sites) stars_.push_back(star_of(site));
}

Stars::Star Stars::star_of(Index site) const {
  const std::vector<Index> seen = sites_around(problem_, site);
  const RadialOrder order(problem_, site);
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
  mutual_.emplace_back();
  for (const Index site : problem_.sites) {
    if (site == segment[0] || site == segment[1]) continue;
    const Sign front = side(edge, site);
    if (front != Sign::zero) hide({edge, site, front});
  }
}

/// Hides what the site sees between the edge's ends, both excluded.
void Stars::hide(const Sight& sight) {
  auto [right, left] = edges_[sight.edge];
  if (sight.front == Sign::negative) std::swap(right, left);
  const Star& star = stars_[local_[sight.site]];
  const Index first = star.direction[local_[right]] + 1, last = star.direction[local_[left]];
  if (first <= last) {
    hide_range(sight, first, last);
  } else {
    hide_range(sight, first, star.directions);
    hide_range(sight, 0, last);
  }
}

/// Offers the edge to the nodes that make up the directions in [first, last).
void Stars::hide_range(const Sight& sight, Index first, Index last) {
  Star& star = stars_[local_[sight.site]];
  const auto offer = [&](Index node) {
    ++steps_;
    Index& closest = star.closest[node];
    if (closest == none || is_closer(sight, closest)) closest = sight.edge;
  };
  first += star.directions;
  last += star.directions;
  for (; first < last; first /= 2, last /= 2) {
    if (first % 2 == 1) offer(first++);
    if (last % 2 == 1) offer(--last);
  }
}

/// Of two edges that do not cross and that one ray from the site meets: whether the ray meets the one in
/// sight before the other. The line of one of them has the other on one side.
bool Stars::is_closer(const Sight& sight, Index other) {
  ++tests_;
  const auto none_on = [](const std::array<Sign, 2>& ends, Sign s) { return ends[0] != s && ends[1] != s; };
  const Mutual& lines = mutual(sight.edge, other);
  if (none_on(lines.older, sight.front)) return true;
  if (none_on(lines.older, -sight.front)) return false;
  return none_on(lines.newer, -side(other, sight.site));
}

const Stars::Mutual& Stars::mutual(Index inserted, Index other) {
  Mutual& lines = mutual_[other];
  if (lines.inserted == inserted) return lines;
  const auto ends_from = [&](Index line, Index edge) {
    return std::array{side(line, edges_[edge][0]), side(line, edges_[edge][1])};
  };
  return lines = {inserted, ends_from(inserted, other), ends_from(other, inserted)};
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
