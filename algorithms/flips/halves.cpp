#include "algorithms/flips/halves.hpp"

#include "algorithms/abandon.hpp"

#include <algorithm>
#include <cassert>

namespace tribunal {
namespace {

struct Site {
  Point2 at;
  Index name;
};

/// Two lexicographic orders of the plane, the second one seen by somebody who has turned by a right angle: in
/// both, what comes first lies left of what comes later, with the same orientations.
enum class Axis : std::uint8_t { x, y };

bool comes_before(Axis axis, Point2 a, Point2 b) {
  if (axis == Axis::x) return a < b;
  return a[1] != b[1] ? a[1] < b[1] : a[0] > b[0];
}

Axis longer_side(std::span<const Site> sites) {
  Point2 low = sites.front().at, high = low;
  for (const Site& site : sites)
    for (const std::size_t axis : {0, 1}) {
      low[axis] = std::min(low[axis], site.at[axis]);
      high[axis] = std::max(high[axis], site.at[axis]);
    }
  return high[0] - low[0] >= high[1] - low[1] ? Axis::x : Axis::y;
}

/// Places [begin, end) in the order. As long as they are collinear they are a path, sorted along its line and
/// without triangles; else `hull` is one of the nodes of their hull.
struct Part {
  Index begin, end;
  bool path;
  Index hull;

  Index size() const { return end - begin; }
};

class Halving {
 public:
  Halving(const Sites& given, std::span<const Index> vertices) : kernel_(given.kernel) {
    sites_.reserve(vertices.size());
    for (const Index v : vertices) sites_.push_back({given.points[v], v});
    nodes_.resize(vertices.size());
    triangles_.reserve(2 * vertices.size());
  }

  Halved run() {
    if (triangulate(0, static_cast<Index>(sites_.size())).path) refuse();
    std::vector<Index> order(sites_.size());
    std::ranges::transform(sites_, order.begin(), &Site::name);
    return {std::move(order), std::move(triangles_)};
  }

 private:
  /// A corner of a hull, which is a cycle, counter-clockwise. That of a path goes there and back, so that its
  /// inner sites have two nodes.
  struct Node {
    Index place, next, prev;
  };

  [[noreturn]] static void refuse() {
    throw Abandon(Outcome::inconsistent_predicate, "the hulls of two halves have no common tangents");
  }
  Sign orient(Index a, Index b, Index c) const {
    return kernel_.orient2d(sites_[a].at, sites_[b].at, sites_[c].at);
  }
  Sign turn(Index a, Index b, Index c) const {
    return orient(nodes_[a].place, nodes_[b].place, nodes_[c].place);
  }

  // Recursion as deep as n can be halved.
  Part triangulate(Index begin, Index end) {
    if (end - begin == 1) return {begin, end, true, 0};
    const std::span range = std::span(sites_).subspan(begin, end - begin);
    const Axis axis = longer_side(range);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(range.begin(), range.begin() + (middle - begin), range.end(),
                     [axis](const Site& a, const Site& b) { return comes_before(axis, a.at, b.at); });
    const Part left = triangulate(begin, middle), right = triangulate(middle, end);
    if (left.path && right.path && are_collinear(left, right)) {
      std::ranges::sort(range, [](const Site& a, const Site& b) { return a.at < b.at; });
      return {begin, end, true, 0};
    }
    return {begin, end, false, join(hull_of(left), hull_of(right), axis)};
  }

  bool are_collinear(const Part& a, const Part& b) const {
    if (a.size() == 1 && b.size() == 1) return true;
    const Part& line = a.size() > 1 ? a : b;
    const Part& other = a.size() > 1 ? b : a;
    return orient(line.begin, line.end - 1, other.begin) == Sign::zero &&
           orient(line.begin, line.end - 1, other.end - 1) == Sign::zero;
  }

  void link(Index node, Index following) {
    nodes_[node].next = following;
    nodes_[following].prev = node;
  }

  Index hull_of(const Part& part) {
    if (!part.path) return part.hull;
    for (Index place = part.begin; place < part.end; ++place) {
      nodes_[place].place = place;
      if (place > part.begin) link(place - 1, place);
    }
    Index last = part.end - 1;
    for (Index place = part.end - 1; place-- > part.begin + 1;) {
      nodes_.push_back({place, 0, 0});
      link(last, static_cast<Index>(nodes_.size() - 1));
      last = static_cast<Index>(nodes_.size() - 1);
    }
    link(last, part.begin);
    return part.begin;
  }

  /// The node of a hull that comes before (after) all others.
  template <bool first>
  Index extreme(Index hull, Axis axis) const {
    Index best = hull;
    for (Index node = nodes_[hull].next; node != hull; node = nodes_[node].next) {
      const Point2 candidate = at(node), least = at(best);
      if (first ? comes_before(axis, candidate, least) : comes_before(axis, least, candidate)) best = node;
    }
    return best;
  }
  Point2 at(Index node) const { return sites_[nodes_[node].place].at; }

  /// Joins the hull that comes first with the other one; returns a node of the hull of both.
  Index join(Index first, Index second, Axis axis) {
    Index left = extreme<false>(first, axis), right = extreme<true>(second, axis);
    find_lower_tangent(left, right);
    const Index lower_left = left, lower_right = right;
    fill_between(left, right);
    link(lower_left, lower_right);
    link(right, left);
    return left;
  }

  void find_lower_tangent(Index& left, Index& right) const {
    // Each step goes down a hull, which wrong signs could go round for ever.
    for (std::size_t steps = 0; steps <= 2 * nodes_.size(); ++steps) {
      if (turn(left, right, nodes_[left].prev) == Sign::negative)
        left = nodes_[left].prev;
      else if (turn(left, right, nodes_[right].next) == Sign::negative)
        right = nodes_[right].next;
      else
        return;
    }
    refuse();
  }

  /// Fills the strip above the tangent left -> right with triangles, and leaves both at the upper tangent. Of
  /// the two triangles that may come next the one is taken whose circle is empty of the other's apex. Hulls
  /// being disjoint, its new side then cuts off none of the other hull.
  void fill_between(Index& left, Index& right) {
    while (true) {
      const Index up_left = nodes_[left].next, up_right = nodes_[right].prev;
      const bool may_left = turn(left, right, up_left) == Sign::positive;
      const bool may_right = turn(left, right, up_right) == Sign::positive;
      if (!may_left && !may_right) return;
      const bool take_left = may_left && (!may_right || kernel_.incircle(at(left), at(right), at(up_right),
                                                                         at(up_left)) == Sign::positive);
      const Index apex = take_left ? up_left : up_right;
      // No triangulation has more.
      if (triangles_.size() >= 2 * sites_.size()) refuse();
      triangles_.push_back({nodes_[left].place, nodes_[right].place, nodes_[apex].place});
      (take_left ? left : right) = apex;
    }
  }

  const Kernel2& kernel_;
  std::vector<Site> sites_;  // in their order
  std::vector<Node> nodes_;  // those of places first
  std::vector<Triangle> triangles_;
};

}  // namespace

Halved triangulate_by_halves(const Sites& sites, std::span<const Index> vertices) {
  assert(vertices.size() >= 3);
  return Halving(sites, vertices).run();
}

}  // namespace tribunal
