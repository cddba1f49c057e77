// Shamos and Hoey (1976): a line sweeps over the plane from left to right and keeps the edges that it meets,
// bottom to top. As long as it has passed no crossing their order is right, and the two edges of the first
// crossing become neighbours before it. Vertices are met in lexicographic order, as by a line leaning a
// little, so vertical edges are no exception. All decisions are orientations of vertices, hence exact.
//
// Triangles overlap without any crossing when one has a vertex of another inside. Some vertex inside it can
// then be seen straight up from its lower edges: where they are first hidden from one another, something
// ends, and it does not end at a corner, for what runs from corner to corner is an edge. So it is enough to
// look, at each vertex, at the triangles on the upper side of the edge next below.
#include "algorithms/verify/crossing.hpp"

#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace tribunal::verify {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

struct Segment {
  std::uint32_t left, right;  ///< ends, left before right in lexicographic order
};

/// The edges of triangles that have an area, each once.
std::vector<Segment> distinct_segments(std::span<const Point2> points, std::span<const EdgeUse> uses) {
  std::vector<Segment> segments;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (std::all_of(edge.begin(), edge.end(), [](const EdgeUse& use) { return use.flat; })) return;
    const auto [low, high] = std::pair(edge[0].low, edge[0].high);
    segments.push_back(points[low] < points[high] ? Segment{low, high} : Segment{high, low});
  });
  return segments;
}

/// The triangles with an area at an edge, and which way they run along it.
std::vector<EdgeUse> uses_of(const Segment& s, std::span<const EdgeUse> uses) {
  const std::pair edge(std::min(s.left, s.right), std::max(s.left, s.right));
  auto use = std::lower_bound(uses.begin(), uses.end(), edge,
                              [](const EdgeUse& u, const auto& e) { return std::pair(u.low, u.high) < e; });
  std::vector<EdgeUse> found;
  for (; use != uses.end() && std::pair(use->low, use->high) == edge; ++use)
    if (!use->flat) found.push_back(*use);
  return found;
}

/// Which side of the line through a segment a vertex is on: positive above it.
struct Side {
  std::span<const Point2> points;
  Sign operator()(const Segment& s, std::uint32_t vertex) const {
    return orientation(points[s.left], points[s.right], points[vertex]);
  }
};

/// Order along the sweep line, bottom to top, of the segments that it meets and of the vertex it has come to.
/// Asked only where nothing is collinear but what shares an end: the sweep stops before.
struct Below {
  using is_transparent = void;
  Side side;
  bool operator()(const Segment& s, const Segment& t) const {
    if (s.left == t.left) return side(s, t.right) == Sign::positive;
    return side.points[s.left] < side.points[t.left] ? side(s, t.left) == Sign::positive
                                                     : side(t, s.left) == Sign::negative;
  }
  bool operator()(const Segment& s, std::uint32_t vertex) const { return side(s, vertex) == Sign::positive; }
};

/// What the sweep found: two edges that cross, or a vertex inside an edge or inside a triangle.
struct Overlap {
  std::vector<Segment> edges;
  std::uint32_t vertex = none;
  std::uint32_t triangle = none;
};

class Sweep {
 public:
  Sweep(std::span<const Point2> points, std::span<const SoundTriangle> triangles,
        std::span<const EdgeUse> uses)
      : side_{points}, triangles_(triangles), uses_(uses), line_(Below{side_}) {}

  /// Takes the line past `vertex`, where the segments `ending` end and `starting` start; says what it found
  /// there. Vertices must come in lexicographic order.
  std::optional<Overlap> pass(std::uint32_t vertex, std::span<const Segment> ending,
                              std::vector<Segment> starting) {
    for (const Segment& s : ending) line_.erase(s);
    std::sort(starting.begin(), starting.end(), line_.key_comp());
    for (std::size_t i = 1; i < starting.size(); ++i)
      if (side_(starting[i - 1], starting[i].right) == Sign::zero)
        return overlap_of(starting[i - 1], starting[i]);

    const auto above = line_.lower_bound(vertex);
    const auto below = above == line_.begin() ? line_.end() : std::prev(above);
    if (above != line_.end() && side_(*above, vertex) == Sign::zero) return Overlap{{*above}, vertex, none};
    if (below != line_.end()) {
      const std::uint32_t triangle = triangle_around(vertex, *below);
      if (triangle != none) return Overlap{{}, vertex, triangle};
    }

    for (const Segment& s : starting) line_.insert(above, s);
    if (starting.empty()) return below == line_.end() ? std::nullopt : crossing(below, above);
    auto found = below == line_.end() ? std::nullopt : crossing(below, std::next(below));
    return found ? found : crossing(std::prev(above), above);
  }

 private:
  using Line = std::set<Segment, Below>;

  /// The nearer end of two collinear segments with the same left end lies inside the other.
  Overlap overlap_of(const Segment& s, const Segment& t) const {
    const bool s_is_shorter = side_.points[s.right] < side_.points[t.right];
    return {{s_is_shorter ? t : s}, s_is_shorter ? s.right : t.right, none};
  }

  /// A triangle on the upper side of the segment next below `vertex` that does not have it as a corner. It
  /// reaches up to its next segment, hence beyond the vertex.
  std::uint32_t triangle_around(std::uint32_t vertex, const Segment& below) const {
    for (const EdgeUse& use : uses_of(below, uses_)) {
      const auto& corners = triangles_[use.sound].corners;
      if (use.from() == below.left && std::find(corners.begin(), corners.end(), vertex) == corners.end())
        return use.sound;
    }
    return none;
  }

  std::optional<Overlap> crossing(Line::const_iterator lower, Line::const_iterator upper) const {
    if (upper == line_.end()) return std::nullopt;
    const Segment &s = *lower, &t = *upper;
    if (s.left == t.left || s.right == t.right) return std::nullopt;
    const bool cross = side_(s, t.left) * side_(s, t.right) == Sign::negative &&
                       side_(t, s.left) * side_(t, s.right) == Sign::negative;
    return cross ? std::optional(Overlap{{s, t}, none, none}) : std::nullopt;
  }

  Side side_;
  std::span<const SoundTriangle> triangles_;
  std::span<const EdgeUse> uses_;
  Line line_;
};

/// Runs the sweep to its first find.
std::optional<Overlap> first_overlap(std::span<const Point2> points, const Sites& sites,
                                     std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                                     bool lone_sites) {
  std::vector<Segment> by_left = distinct_segments(points, uses), by_right = by_left;
  std::vector<std::uint32_t> rank(points.size());
  for (std::uint32_t i = 0; i < sites.sorted.size(); ++i) rank[sites.sorted[i]] = i;
  const auto sort_by = [&](std::vector<Segment>& segments, auto key) {
    std::sort(segments.begin(), segments.end(),
              [&](const Segment& s, const Segment& t) { return key(s) < key(t); });
  };
  sort_by(by_left, [&](const Segment& s) { return std::pair(rank[s.left], rank[s.right]); });
  sort_by(by_right, [&](const Segment& s) { return std::pair(rank[s.right], rank[s.left]); });

  Sweep sweep(points, triangles, uses);
  std::size_t started = 0, ended = 0;
  for (const std::uint32_t vertex : sites.sorted) {
    const std::size_t first_end = ended, first_start = started;
    while (ended < by_right.size() && by_right[ended].right == vertex) ++ended;
    while (started < by_left.size() && by_left[started].left == vertex) ++started;
    const bool lone = ended == first_end && started == first_start;
    if (lone && !lone_sites) continue;
    const auto ending = std::span(by_right).subspan(first_end, ended - first_end);
    const auto starting = std::span(by_left).subspan(first_start, started - first_start);
    if (auto found = sweep.pass(vertex, ending, {starting.begin(), starting.end()})) return found;
  }
  return std::nullopt;
}

void sort_unique(std::vector<std::uint32_t>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

void find_crossing(std::span<const Point2> points, const Sites& sites,
                   std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses, FaultList& faults,
                   bool lone_sites) {
  const auto overlap = first_overlap(points, sites, triangles, uses, lone_sites);
  if (!overlap) return;
  std::vector<std::uint32_t> concerned, named;
  for (const Segment& s : overlap->edges) {
    for (const EdgeUse& use : uses_of(s, uses)) concerned.push_back(triangles[use.sound].index);
    named.push_back(std::min(s.left, s.right));
    named.push_back(std::max(s.left, s.right));
  }
  if (overlap->triangle != none) {
    const SoundTriangle& triangle = triangles[overlap->triangle];
    concerned.push_back(triangle.index);
    named.assign(triangle.corners.begin(), triangle.corners.end());
  }
  if (overlap->vertex != none) {
    const auto at_vertex = std::find_if(triangles.begin(), triangles.end(), [&](const SoundTriangle& t) {
      return std::find(t.corners.begin(), t.corners.end(), overlap->vertex) != t.corners.end() &&
             t.orientation != Sign::zero;
    });
    if (at_vertex != triangles.end()) concerned.push_back(at_vertex->index);
    named.insert(named.begin(), overlap->vertex);
  }
  sort_unique(concerned);
  faults.add(FaultKind::crossing_edges, concerned, named,
             overlap->vertex == none ? "have edges that cross"
                                     : "overlap: a vertex lies inside an edge or triangle");
}

}  // namespace tribunal::verify
