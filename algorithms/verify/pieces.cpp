#include "algorithms/verify/pieces.hpp"

#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>
#include <optional>

namespace tribunal::verify {
namespace {

bool strictly_between(Point2 a, Point2 q, Point2 b) { return (a < q && q < b) || (b < q && q < a); }

/// Each vertex with its neighbours, sorted.
class Neighbours {
 public:
  explicit Neighbours(std::span<const EdgeUse> uses) {
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      pairs_.push_back({edge[0].low, edge[0].high});
      pairs_.push_back({edge[0].high, edge[0].low});
    });
    std::sort(pairs_.begin(), pairs_.end());
  }
  std::span<const std::array<std::uint32_t, 2>> of(std::uint32_t vertex) const {
    const auto begin = std::lower_bound(pairs_.begin(), pairs_.end(), std::array{vertex, 0U});
    return {begin, std::upper_bound(begin, pairs_.end(), std::array{vertex, 0xFFFFFFFFU})};
  }
  bool has(std::uint32_t from, std::uint32_t to) const {
    return std::binary_search(pairs_.begin(), pairs_.end(), std::array{from, to});
  }

 private:
  std::vector<std::array<std::uint32_t, 2>> pairs_;
};

/// Whether the open segment cd meets the inside of a triangle: unless a line along an edge of either
/// separates them.
bool meets_inside(std::span<const Point2> points, const SoundTriangle& triangle, Point2 c, Point2 d) {
  std::array<Point2, 3> v{points[triangle.corners[0]], points[triangle.corners[1]],
                          points[triangle.corners[2]]};
  if (triangle.orientation == Sign::zero) return false;
  if (triangle.orientation == Sign::negative) std::swap(v[1], v[2]);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax({v[0][axis], v[1][axis], v[2][axis]});
    if (std::max(c[axis], d[axis]) < low || high < std::min(c[axis], d[axis])) return false;
  }
  bool some_left = false, some_right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 from = v[i], to = v[(i + 1) % 3];
    if (orientation(from, to, c) != Sign::positive && orientation(from, to, d) != Sign::positive)
      return false;
    const Sign side = orientation(c, d, from);
    some_left |= side == Sign::positive;
    some_right |= side == Sign::negative;
  }
  return some_left && some_right;
}

class Follower {
 public:
  Follower(std::span<const Point2> points, const Sites& sites, std::span<const SoundTriangle> triangles,
           std::span<const EdgeUse> uses, bool everywhere, FaultList& faults)
      : points_(points),
        sites_(sites),
        triangles_(triangles),
        neighbours_(uses),
        everywhere_(everywhere),
        faults_(faults) {}

  void follow(std::uint32_t a, std::uint32_t b) {
    if (neighbours_.of(b).size() < neighbours_.of(a).size()) std::swap(a, b);  // hubs are costly to leave
    for (std::uint32_t at = a; at != b;) {
      auto next = along_edge(a, at, b);
      const bool on_mesh = next.has_value();
      if (!next) next = next_site(a, at, b);
      if (!on_mesh && !may_leave_mesh(at, *next)) {
        faults_.add(FaultKind::missing_segment, {}, {std::min(a, b), std::max(a, b), at},
                    "the edges do not follow a segment");
        return;
      }
      pieces_.push_back({std::min(at, *next), std::max(at, *next), 1, on_mesh});
      at = *next;
    }
  }

  /// Pieces that run over each other become one.
  std::vector<Piece> take() {
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) {
      return std::pair(p.low, p.high) < std::pair(q.low, q.high);
    });
    std::vector<Piece> merged;
    for (const Piece& piece : pieces_) {
      if (merged.empty() || merged.back().low != piece.low || merged.back().high != piece.high)
        merged.push_back(piece);
      else
        ++merged.back().segments;
    }
    return merged;
  }

 private:
  std::optional<std::uint32_t> along_edge(std::uint32_t a, std::uint32_t at, std::uint32_t b) const {
    if (neighbours_.has(at, b)) return b;
    for (const auto& [from, to] : neighbours_.of(at))
      if (strictly_between(points_[at], points_[to], points_[b]) &&
          orientation(points_[a], points_[b], points_[to]) == Sign::zero)
        return to;
    return std::nullopt;
  }
  std::uint32_t next_site(std::uint32_t a, std::uint32_t at, std::uint32_t b) const {
    std::uint32_t next = b;
    for (const std::uint32_t site : sites_.sorted)
      if (strictly_between(points_[at], points_[site], points_[next]) &&
          orientation(points_[a], points_[b], points_[site]) == Sign::zero)
        next = site;
    return next;
  }
  bool may_leave_mesh(std::uint32_t from, std::uint32_t to) const {
    return !everywhere_ && std::none_of(triangles_.begin(), triangles_.end(), [&](const SoundTriangle& t) {
      return meets_inside(points_, t, points_[from], points_[to]);
    });
  }

  std::span<const Point2> points_;
  const Sites& sites_;
  std::span<const SoundTriangle> triangles_;
  Neighbours neighbours_;
  bool everywhere_;
  FaultList& faults_;
  std::vector<Piece> pieces_;
};

/// Looks up on which sides of the pieces there are triangles.
void note_cover(std::span<const EdgeUse> uses, std::vector<Piece>& pieces) {
  auto piece = pieces.begin();
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const std::pair ends(edge[0].low, edge[0].high);
    while (piece != pieces.end() && std::pair(piece->low, piece->high) < ends) ++piece;
    if (piece == pieces.end() || std::pair(piece->low, piece->high) != ends) return;
    for (const EdgeUse& use : edge) (use.upward ? piece->left_covered : piece->right_covered) = true;
  });
}

}  // namespace

std::vector<Piece> follow_segments(std::span<const Point2> points, const Sites& sites,
                                   std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                                   const Segments& segments, FaultList& faults) {
  Follower follower(points, sites, triangles, uses, segments.domain == Domain::hull, faults);
  for (const auto& [a, b] : segments.segments)
    follower.follow(sites.representative[a], sites.representative[b]);
  std::vector<Piece> pieces = follower.take();
  note_cover(uses, pieces);
  return pieces;
}

}  // namespace tribunal::verify
