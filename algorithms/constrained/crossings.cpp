#include "algorithms/constrained/crossings.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/constrained/rational_point.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/formulas/segment_intersection.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

namespace tribunal {
namespace {

constexpr int most_rounds = 128;
/// Pieces of more than so many times what the first round makes are a sign that rounding makes more crossings
/// than it ends.
constexpr std::size_t most_growth = 64;
/// Of pieces that are nearly parallel each round may bend one across another a little farther on, by a
/// double, and near an axis doubles are fine without end. After so many rounds that leave no fewer crossings
/// than there were, crossing points go to coarser numbers: what crosses close to a coordinate that is there
/// already goes to that one, so that pieces meet in vertices they have.
constexpr int patience = 8;

/// What crossing points are rounded to after so many rounds in vain: slowly coarser, for what is coarse among
/// fine pieces crosses more of them.
CoarseNumbers coarse_numbers(std::span<const Point2> points, int rounds) {
  return {points, 1 + rounds / 16, 2 * rounds - 60};
}

/// A crossing on a segment: where exactly, and the index of the point that stands for it.
struct Crossing {
  Index segment;
  RationalPoint exact;
  Index point;
};

class Splitter {
 public:
  explicit Splitter(const Graph& graph) {
    split_.points.assign(graph.points.begin(), graph.points.end());
    split_.segments.assign(graph.segments.begin(), graph.segments.end());
    split_.origin.resize(split_.segments.size());
    std::iota(split_.origin.begin(), split_.origin.end(), Index{0});
    for (Index i = 0; i < split_.points.size(); ++i) index_.try_emplace(split_.points[i], i);
  }

  SplitGraph run() {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    std::size_t first = 0;
    int stalled = 0;
    Edge last{};
    for (int round = 0; round < most_rounds; ++round) {
      bind();
      const std::vector<Edge> pairs = crossing_pairs();
      if (pairs.empty()) return std::move(split_);
      stalled += pairs.size() >= fewest;
      fewest = std::min(fewest, pairs.size());
      if (stalled >= patience) coarse_ = coarse_numbers(split_.points, stalled - patience);
      last = {split_.origin[pairs[0][0]], split_.origin[pairs[0][1]]};
      split_at(pairs);
      if (round == 0) first = split_.segments.size();
      if (split_.segments.size() > most_growth * first) break;
    }
    throw UnsettledCrossing(last);
  }

 private:
  Point2 at(Index point) const { return split_.points[point]; }

  void bind() {
    Kernel2Binding bound = find_backend("filtered")->bind2(split_.points);
    if (const auto* refusal = std::get_if<Refusal>(&bound))
      throw Abandon(Outcome::refused_input, refusal->reason);
    kernel_ = std::get<0>(std::move(bound));
  }

  bool crosses(const Edge& s, const Edge& t) const {
    const auto [a, b] = std::pair(at(s[0]), at(s[1]));
    const auto [c, d] = std::pair(at(t[0]), at(t[1]));
    if (std::max(a[1], b[1]) < std::min(c[1], d[1]) || std::max(c[1], d[1]) < std::min(a[1], b[1]))
      return false;
    return intersect_segments(*kernel_, a, b, c, d) == SegmentIntersection::crossing;
  }

  /// Segments are met from left to right; each is compared with those that reach as far.
  std::vector<Edge> crossing_pairs() const {
    const auto& segments = split_.segments;
    const auto left = [&](Index s) { return std::min(at(segments[s][0])[0], at(segments[s][1])[0]); };
    const auto right = [&](Index s) { return std::max(at(segments[s][0])[0], at(segments[s][1])[0]); };
    std::vector<Index> order, active;
    for (Index s = 0; s < segments.size(); ++s)
      if (!(at(segments[s][0]) == at(segments[s][1]))) order.push_back(s);
    std::stable_sort(order.begin(), order.end(), [&](Index s, Index t) { return left(s) < left(t); });
    std::vector<Edge> pairs;
    for (const Index s : order) {
      std::erase_if(active, [&](Index t) { return right(t) < left(s); });
      for (const Index t : active)
        if (crosses(segments[s], segments[t])) pairs.push_back({t, s});
      active.push_back(s);
    }
    return pairs;
  }

  Index point_at(const RationalPoint& exact) {
    const Point2 rounded = coarse_ ? coarse_->nearest(exact) : nearest(exact);
    const auto [found, is_new] = index_.try_emplace(rounded, static_cast<Index>(split_.points.size()));
    if (is_new) split_.points.push_back(rounded);
    if (is_new && !(exact == rational(rounded))) ++split_.rounded;
    return found->second;
  }

  void split_at(const std::vector<Edge>& pairs) {
    std::vector<Crossing> crossings;
    for (const auto& [s, t] : pairs) {
      const Edge first = split_.segments[s], second = split_.segments[t];
      const RationalPoint exact = intersection(at(first[0]), at(first[1]), at(second[0]), at(second[1]));
      const Index point = point_at(exact);
      crossings.push_back({s, exact, point});
      crossings.push_back({t, exact, point});
    }
    bind();
    std::stable_sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
      return a.segment != b.segment ? a.segment < b.segment : a.exact < b.exact;
    });
    const std::vector<Index> sorted = points_from_left_to_right();
    std::vector<Edge> segments;
    std::vector<Index> origin;
    std::size_t next = 0;
    for (Index s = 0; s < split_.segments.size(); ++s) {
      const std::size_t begin = next;
      while (next < crossings.size() && crossings[next].segment == s) ++next;
      const auto chain = chain_of(s, std::span(crossings).subspan(begin, next - begin), sorted);
      for (std::size_t i = 1; i < chain.size(); ++i) {
        segments.push_back({chain[i - 1], chain[i]});
        origin.push_back(split_.origin[s]);
      }
    }
    split_.segments = std::move(segments);
    split_.origin = std::move(origin);
  }

  std::vector<Index> points_from_left_to_right() const {
    std::vector<Index> sorted;
    for (const auto& [position, index] : index_) sorted.push_back(index);
    return sorted;
  }

  /// The vertices that segment s is to run through now, from its start to its end.
  std::vector<Index> chain_of(Index s, std::span<const Crossing> crossings,
                              const std::vector<Index>& sorted) {
    auto [from, to] = split_.segments[s];
    if (crossings.empty()) return {from, to};
    const bool backwards = at(to) < at(from);
    if (backwards) std::swap(from, to);
    std::vector<Index> chain{from};
    for (const Crossing& crossing : crossings) chain.push_back(crossing.point);
    chain.push_back(to);
    chain.erase(std::unique(chain.begin(), chain.end(), [this](Index a, Index b) { return at(a) == at(b); }),
                chain.end());
    chain.back() = to;
    snap(from, to, sorted, chain);
    if (backwards) std::reverse(chain.begin(), chain.end());
    return chain;
  }

  /// Vertices on the segment from `from` to `to`, and those between it and the chain that takes its place,
  /// become vertices of the chain. Rounding is monotone in each coordinate, so both run one way in x and one
  /// way in y.
  void snap(Index from, Index to, const std::vector<Index>& sorted, std::vector<Index>& chain) {
    const bool falls = at(to)[1] < at(from)[1];
    const auto before = [&](Index a, Index b) {
      if (at(a)[0] != at(b)[0]) return at(a)[0] < at(b)[0];
      return falls ? at(a)[1] > at(b)[1] : at(a)[1] < at(b)[1];
    };
    std::size_t piece = 0;
    for (const Index v : vertices_in_box(from, to, sorted, before)) {
      while (before(chain[piece + 1], v)) ++piece;
      if (at(chain[piece + 1]) == at(v)) continue;
      const Sign side = kernel_->orient2d(at(from), at(to), at(v));
      const Sign side_of_chain = kernel_->orient2d(at(chain[piece]), at(chain[piece + 1]), at(v));
      if (side != Sign::zero && side_of_chain != -side) continue;
      split_.snapped += side != Sign::zero;
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(piece) + 1, v);
    }
  }

  /// The vertices in the box of a segment, its ends left out, in the order along it.
  template <class Before>
  std::vector<Index> vertices_in_box(Index from, Index to, const std::vector<Index>& sorted,
                                     Before before) const {
    const auto [low, high] = std::minmax({at(from)[1], at(to)[1]});
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), at(from)[0],
                                        [this](Index v, double x) { return at(v)[0] < x; });
    std::vector<Index> inside;
    for (auto v = first; v != sorted.end() && at(*v)[0] <= at(to)[0]; ++v)
      if (low <= at(*v)[1] && at(*v)[1] <= high && before(from, *v) && before(*v, to)) inside.push_back(*v);
    std::sort(inside.begin(), inside.end(), before);
    return inside;
  }

  SplitGraph split_;
  std::map<Point2, Index> index_;  // of each position, its first point
  std::unique_ptr<const Kernel2> kernel_;
  std::optional<CoarseNumbers> coarse_;
};

}  // namespace

SplitGraph split_crossings(const Graph& graph) { return Splitter(graph).run(); }

}  // namespace tribunal
