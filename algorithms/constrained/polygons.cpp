#include "algorithms/constrained/polygons.hpp"

#include "algorithms/duplicates.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace tribunal::constrained {
namespace {

/// The segments of a ring, by horizontal bands, to be asked what they enclose.
class Enclosure {
 public:
  Enclosure(const Graph& graph, std::span<const Index> segments, const Kernel2& kernel)
      : graph_(graph), kernel_(kernel) {
    assert(!segments.empty());
    std::vector<double> heights;
    for (const Index s : segments) heights.push_back(start(s)[1]);
    std::sort(heights.begin(), heights.end());
    const auto stride = static_cast<std::size_t>(std::sqrt(static_cast<double>(heights.size())));
    for (std::size_t i = stride; i < heights.size(); i += stride) borders_.push_back(heights[i]);
    bands_.resize(borders_.size() + 1);
    for (const Index s : segments) {
      const double from = start(s)[1], to = end(s)[1];
      for (std::size_t b = band(std::min(from, to)), last = band(std::max(from, to)); b <= last; ++b)
        bands_[b].push_back(s);
    }
  }

  /// Whether the point, which is on none of them, has an odd number of segments to its right.
  bool holds(Point2 p) const {
    bool odd = false;
    for (const Index s : bands_[band(p[1])]) {
      const Point2 a = start(s), b = end(s);
      if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
      const Sign side = kernel_.orient2d(a, b, p);
      odd ^= (side == Sign::positive) == (b[1] > a[1]);
    }
    return odd;
  }

 private:
  Point2 start(Index segment) const { return graph_.points[graph_.segments[segment][0]]; }
  Point2 end(Index segment) const { return graph_.points[graph_.segments[segment][1]]; }
  std::size_t band(double y) const {
    return static_cast<std::size_t>(std::upper_bound(borders_.begin(), borders_.end(), y) - borders_.begin());
  }

  const Graph& graph_;
  const Kernel2& kernel_;
  std::vector<double> borders_;
  std::vector<std::vector<Index>> bands_;
};

/// A ring passes through a point, duplicates standing for the first of them.
struct Passage {
  Index ring, point;

  friend bool operator==(const Passage&, const Passage&) = default;
  friend bool operator<(const Passage& a, const Passage& b) {
    return std::pair(a.ring, a.point) < std::pair(b.ring, b.point);
  }
};

class Rings {
 public:
  Rings(const Graph& graph, const Polygons& polygons, std::span<const Touch> touches)
      : polygons_(polygons), segments_(polygons.outer.size()), first_(first_occurrences(graph.points)) {
    for (Index s = 0; s < graph.segments.size(); ++s) {
      if (polygons.ring[s] == Polygons::no_ring) continue;
      segments_[polygons.ring[s]].push_back(s);
      corners_.push_back({polygons.ring[s], first_[graph.segments[s][0]]});
    }
    std::sort(corners_.begin(), corners_.end());
    for (const Touch& touch : touches)
      if (polygons.ring[touch.segment] != Polygons::no_ring)
        touched_.push_back({polygons.ring[touch.segment], first_[touch.vertex]});
    std::sort(touched_.begin(), touched_.end());
  }

  std::span<const Index> segments(Index ring) const { return segments_[ring]; }

  /// Each corner starts one segment of its ring.
  std::optional<Index> meets_itself() const {
    const auto twice = std::adjacent_find(corners_.begin(), corners_.end());
    if (twice != corners_.end()) return twice->point;
    for (const Passage& touched : touched_)
      if (std::binary_search(corners_.begin(), corners_.end(), touched)) return touched.point;
    return std::nullopt;
  }
  bool passes(Index ring, Index point) const {
    const Passage passage{ring, first_[point]};
    return std::binary_search(corners_.begin(), corners_.end(), passage) ||
           std::binary_search(touched_.begin(), touched_.end(), passage);
  }

 private:
  Polygons polygons_;
  std::vector<std::vector<Index>> segments_;
  std::vector<Index> first_;
  std::vector<Passage> corners_, touched_;
};

/// A corner of an inner ring that its outer ring does not hold: without crossing it a ring may still leave it
/// through its corners. A ring all of whose corners are on the outer one leaves nothing between them, or lies
/// outside.
std::optional<Index> corner_outside(const Graph& graph, const Rings& rings, Index inner, Index outer,
                                    const Enclosure& enclosure) {
  bool inside = false;
  for (const Index s : rings.segments(inner)) {
    const Index corner = graph.segments[s][0];
    if (rings.passes(outer, corner)) continue;
    if (!enclosure.holds(graph.points[corner])) return corner;
    inside = true;
  }
  return inside ? std::nullopt : std::optional(graph.segments[rings.segments(inner)[0]][0]);
}

/// A corner of the outer ring that an inner one holds: an edge of it then leads from corner to corner through
/// a bay. Only a ring that touches the outer one twice can do that.
std::optional<Index> corner_held(const Graph& graph, const Rings& rings, Index inner, Index outer,
                                 const Kernel2& kernel) {
  const auto touching = std::count_if(rings.segments(inner).begin(), rings.segments(inner).end(),
                                      [&](Index s) { return rings.passes(outer, graph.segments[s][0]); });
  if (touching < 2) return std::nullopt;
  const Enclosure enclosure(graph, rings.segments(inner), kernel);
  for (const Index s : rings.segments(outer)) {
    const Index corner = graph.segments[s][0];
    if (!rings.passes(inner, corner) && enclosure.holds(graph.points[corner])) return corner;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RingFault> find_ring_fault(const Graph& graph, const Polygons& polygons,
                                         std::span<const Touch> touches, const Kernel2& kernel) {
  assert(polygons.ring.size() == graph.segments.size());
  const Rings rings(graph, polygons, touches);
  if (const auto point = rings.meets_itself()) return RingFault{RingFault::Kind::touches_itself, *point};
  std::optional<Enclosure> enclosure;
  Index enclosing = Polygons::no_ring;
  for (Index ring = 0; ring < polygons.outer.size(); ++ring) {
    const Index outer = polygons.outer[ring];
    if (ring == outer) continue;
    if (outer != enclosing) enclosure.emplace(graph, rings.segments(outer), kernel);
    enclosing = outer;
    if (const auto corner = corner_outside(graph, rings, ring, outer, *enclosure))
      return RingFault{RingFault::Kind::outside_outer_ring, *corner};
    if (const auto corner = corner_held(graph, rings, ring, outer, kernel))
      return RingFault{RingFault::Kind::outside_outer_ring, *corner};
  }
  return std::nullopt;
}

}  // namespace tribunal::constrained
