// A region lies on the left of the loops of directed pieces around it: one that runs around it
// counter-clockwise, if it is bounded, and others, clockwise or around nothing, about what stands inside.
// Which of them belong together is found by looking up from the top of each inner loop, and from each hole:
// what is seen first bounds the same region from above.
#include "algorithms/verify/faces.hpp"

#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tribunal::verify {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

class Faces {
 public:
  /// Directed piece 2 i runs from low to high, 2 i + 1 back.
  Faces(std::span<const Point2> points, std::span<const Piece> pieces) : points_(points), pieces_(pieces) {
    sort_around_vertices();
    trace_loops();
    sort_into_strips();
  }

  std::uint32_t loops() const { return static_cast<std::uint32_t>(outer_.size()); }
  std::uint32_t loop_of(std::uint32_t directed) const { return loop_[directed]; }
  bool covered(std::uint32_t directed) const {
    const Piece& piece = pieces_[directed / 2];
    return directed % 2 == 0 ? piece.left_covered : piece.right_covered;
  }
  bool is_outer(std::uint32_t loop) const { return outer_[loop]; }
  /// A directed piece of the loop.
  std::uint32_t start(std::uint32_t loop) const { return start_[loop]; }
  std::vector<std::uint32_t> corners(std::uint32_t loop) const {
    std::vector<std::uint32_t> found;
    for_each_of(loop, [&](std::uint32_t d) { found.push_back(from(d)); });
    return found;
  }

  /// The directed piece next above p (pieces at `vertex` left out), with p's region on its left.
  std::optional<std::uint32_t> above(Point2 p, std::uint32_t vertex) const {
    std::optional<std::uint32_t> lowest;
    for (const std::uint32_t i : strips_[strip(p[0])]) {
      if (pieces_[i].low == vertex || pieces_[i].high == vertex) continue;
      const auto [left, right] = ends(i);
      if (!(points_[left][0] <= p[0] && p[0] < points_[right][0])) continue;
      if (orientation(points_[left], points_[right], p) != Sign::negative) continue;
      if (!lowest || below(i, *lowest)) lowest = i;
    }
    if (!lowest) return std::nullopt;
    return 2 * *lowest + (ends(*lowest)[0] == pieces_[*lowest].low ? 1 : 0);
  }
  /// The outer loop of the region on the left of a directed piece; `none` for the unbounded one.
  std::uint32_t region(std::uint32_t directed) const {
    std::uint32_t loop = loop_of(directed);
    for (std::uint32_t looks = 0; !is_outer(loop) && looks <= loops(); ++looks) {
      const std::uint32_t top = highest(loop);
      const auto next = above(points_[top], top);
      if (!next) return none;
      loop = loop_of(*next);
    }
    return is_outer(loop) ? loop : none;
  }

 private:
  std::uint32_t from(std::uint32_t d) const { return d % 2 == 0 ? pieces_[d / 2].low : pieces_[d / 2].high; }
  std::uint32_t to(std::uint32_t d) const { return from(d ^ 1); }

  /// Left end, right end.
  std::array<std::uint32_t, 2> ends(std::uint32_t piece) const {
    const auto [low, high] = std::pair(pieces_[piece].low, pieces_[piece].high);
    return points_[low] < points_[high] ? std::array{low, high} : std::array{high, low};
  }
  /// Of two pieces that do not cross, where some vertical line meets both.
  bool below(std::uint32_t s, std::uint32_t t) const {
    const auto [s_left, s_right] = ends(s);
    const auto [t_left, t_right] = ends(t);
    const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      return orientation(points_[a], points_[b], points_[c]);
    };
    if (s_left == t_left) return side(s_left, s_right, t_right) == Sign::positive;
    return points_[s_left] < points_[t_left] ? side(s_left, s_right, t_left) == Sign::positive
                                             : side(t_left, t_right, s_left) == Sign::negative;
  }

  /// Directed pieces by where they start, counter-clockwise from the direction of the x axis.
  void sort_around_vertices() {
    around_.resize(2 * pieces_.size());
    for (std::uint32_t d = 0; d < around_.size(); ++d) around_[d] = d;
    const auto upper = [&](std::uint32_t d) {
      const Point2 a = points_[from(d)], b = points_[to(d)];
      return b[1] > a[1] || (b[1] == a[1] && b[0] > a[0]);
    };
    std::sort(around_.begin(), around_.end(), [&](std::uint32_t c, std::uint32_t d) {
      if (from(c) != from(d)) return from(c) < from(d);
      if (upper(c) != upper(d)) return upper(c);
      return orientation(points_[from(c)], points_[to(c)], points_[to(d)]) == Sign::positive;
    });
    place_.resize(around_.size());
    for (std::uint32_t i = 0; i < around_.size(); ++i) place_[around_[i]] = i;
  }
  /// The next directed piece around the region on the left of d: where d ends, the first one clockwise from
  /// its reverse.
  std::uint32_t next(std::uint32_t d) const {
    const std::uint32_t place = place_[d ^ 1], vertex = to(d);
    if (place > 0 && from(around_[place - 1]) == vertex) return around_[place - 1];
    std::uint32_t last = place;
    while (last + 1 < around_.size() && from(around_[last + 1]) == vertex) ++last;
    return around_[last];
  }
  template <class Visit>
  void for_each_of(std::uint32_t loop, Visit visit) const {
    std::uint32_t d = start_[loop];
    do {
      visit(d);
      d = next(d);
    } while (d != start_[loop]);
  }

  void trace_loops() {
    loop_.assign(around_.size(), none);
    for (std::uint32_t d = 0; d < around_.size(); ++d) {
      if (loop_[d] != none) continue;
      const auto loop = static_cast<std::uint32_t>(start_.size());
      start_.push_back(d);
      std::vector<std::array<Point2, 2>> edges;
      for_each_of(loop, [&](std::uint32_t part) {
        loop_[part] = loop;
        edges.push_back({points_[from(part)], points_[to(part)]});
      });
      outer_.push_back(enclosed_area(edges) == Sign::positive);
    }
  }
  /// Pieces by the vertical strips that they reach into: about the root of their number, with as many left
  /// ends in each.
  void sort_into_strips() {
    std::vector<double> lefts;
    lefts.reserve(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) lefts.push_back(points_[ends(i)[0]][0]);
    std::sort(lefts.begin(), lefts.end());
    const auto stride = static_cast<std::size_t>(std::sqrt(static_cast<double>(lefts.size())));
    for (std::size_t i = stride; i < lefts.size(); i += stride) borders_.push_back(lefts[i]);
    strips_.resize(borders_.size() + 1);
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const auto [left, right] = ends(i);
      for (std::size_t k = strip(points_[left][0]), last = strip(points_[right][0]); k <= last; ++k)
        strips_[k].push_back(i);
    }
  }
  std::size_t strip(double x) const {
    return static_cast<std::size_t>(std::upper_bound(borders_.begin(), borders_.end(), x) - borders_.begin());
  }

  std::uint32_t highest(std::uint32_t loop) const {
    std::uint32_t top = from(start_[loop]);
    for_each_of(loop, [&](std::uint32_t d) {
      if (points_[from(d)][1] > points_[top][1]) top = from(d);
    });
    return top;
  }

  std::span<const Point2> points_;
  std::span<const Piece> pieces_;
  std::vector<std::uint32_t> around_, place_;  // directed pieces around vertices, and where each stands there
  std::vector<std::uint32_t> loop_;            // of each directed piece
  std::vector<std::uint32_t> start_;           // of each loop
  std::vector<bool> outer_;                    // of each loop: it runs around its region counter-clockwise
  std::vector<double> borders_;                // between strips
  std::vector<std::vector<std::uint32_t>> strips_;  // the pieces in each
};

}  // namespace

void check_regions(std::span<const Point2> points, std::span<const Piece> pieces,
                   std::span<const Point2> holes, FaultList& faults) {
  const Faces faces(points, pieces);
  std::vector<bool> marked(faces.loops(), false);
  for (const Point2& hole : holes) {
    const auto seen = faces.above(hole, none);
    if (!seen) continue;
    const Piece& piece = pieces[*seen / 2];
    if (faces.covered(*seen))
      faults.add(FaultKind::wrong_domain, {}, {piece.low, piece.high}, "a hole below this edge is covered");
    const std::uint32_t region = faces.region(*seen);
    if (region != none) marked[region] = true;
  }
  for (std::uint32_t loop = 0; loop < faces.loops(); ++loop)
    if (faces.is_outer(loop) && !marked[loop] && !faces.covered(faces.start(loop)))
      faults.add(FaultKind::wrong_domain, {}, faces.corners(loop), "a region without a hole is not covered");
}

}  // namespace tribunal::verify
