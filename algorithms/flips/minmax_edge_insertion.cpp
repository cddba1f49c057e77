#include "algorithms/flips/minmax_edge_insertion.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/mesh/assemble.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>

namespace tribunal {
namespace {

/// A corner of a chain, and the edge that leads to it from the corner before: a half-edge of a triangle that
/// is to go, or of an ear that was cut.
struct Link {
  Index vertex;
  HalfEdge edge;
  bool cut = false;
};

/// The triangle of three corners in a row, cut off; it takes the slot of one that is to go.
struct Ear {
  Index slot;
  Link a, b, c;  ///< the edges that lead to b and c are its sides
};

/// An edge to be inserted: what it crosses, and how the two polygons that it opens are filled.
struct Insertion {
  std::vector<Index> crossed;     ///< triangles, from one end to the other
  std::vector<Link> right, left;  ///< chains of the polygons: from q to s, from s to q, inside on the left
  std::vector<Ear> ears;
};

class EdgeInserter {
 public:
  EdgeInserter(const Sites& sites, std::span<const Triangle> triangles)
      : sites_(sites),
        mesh_(assemble(triangles)),
        finite_(static_cast<Index>(triangles.size())),
        stamps_(finite_, 0),
        renamed_(3 * triangles.size(), PlanarMesh::none),
        worst_([this](const Corner& p, const Corner& q) { return is_smaller(p, q); }) {
    for (const Triangle& t : triangles) vertices_.insert(vertices_.end(), t.begin(), t.end());
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (Index t = 0; t < finite_; ++t) note_largest_corner(t);
  }

  EdgeInsertionResult run() && {
    Budget budget(vertices_.size() * vertices_.size() + 1, "edge insertion");
    while (break_angle(worst_corner())) budget.spend();
    EdgeInsertionResult result{{}, counts_};
    for (Index t = 0; t < finite_; ++t) result.triangles.push_back(mesh_.triangle(t));
    return result;
  }

 private:
  /// The largest angle of a triangle when it was noted; stale when the slot has another stamp since.
  struct Corner {
    Triangle at;  // {x, apex, y}
    Index slot;
    std::uint32_t stamp;
  };
  bool is_smaller(const Corner& p, const Corner& q) const {
    const Sign sign = sites_.compare_angle(p.at, q.at);
    return sign == Sign::zero ? p.slot > q.slot : sign == Sign::negative;
  }
  void note_largest_corner(Index t) {
    worst_.push({largest_corner(sites_, mesh_.triangle(t)), t, ++stamps_[t]});
  }
  Corner worst_corner() {
    while (worst_.top().stamp != stamps_[worst_.top().slot]) worst_.pop();
    return worst_.top();
  }

  /// Tries edges from the corner's apex across the side opposite it, until one can be inserted.
  bool break_angle(const Corner& corner) {
    HalfEdge opposite = 3 * corner.slot;
    while (mesh_.corner(opposite) != corner.at[1]) ++opposite;
    const Index q = corner.at[1], x = mesh_.from(opposite), y = mesh_.to(opposite);
    for (const Index s : vertices_) {
      ++counts_.candidates;
      if (s == q || s == x || s == y || sites_.orient(q, x, s) != Sign::positive ||
          sites_.orient(q, y, s) != Sign::negative || sites_.orient(x, y, s) != Sign::negative)
        continue;
      const auto [least, most] = std::minmax(q, s);
      const std::uint64_t name = std::uint64_t{least} << 32 | most;
      if (hopeless_.contains(name)) continue;
      ++counts_.attempts;
      Insertion insertion;
      if (open(opposite, s, insertion) && fill(insertion, corner.at)) {
        commit(insertion);
        return true;
      }
      hopeless_.insert(name);
    }
    return false;
  }

  /// Follows the edge from the corner of `opposite` to s. False where it meets a vertex in between.
  bool open(HalfEdge opposite, Index s, Insertion& insertion) {
    const Index q = mesh_.corner(opposite);
    insertion.crossed = {triangle_of(opposite)};
    insertion.right = {{q, PlanarMesh::none}, {mesh_.from(opposite), prev(opposite)}};
    std::vector<Link> left{{q, next(opposite)}, {mesh_.to(opposite), PlanarMesh::none}};  // edges to come
    for (HalfEdge crossed = opposite;;) {
      ++counts_.crossings;
      const HalfEdge entered = mesh_.twin(crossed);
      const Index t = triangle_of(entered), z = mesh_.corner(entered);
      if (t >= finite_ || insertion.crossed.size() > finite_)
        throw Abandon(Outcome::inconsistent_predicate,
                      "an edge to be inserted leaves the hull or never ends");
      insertion.crossed.push_back(t);
      const Sign side = z == s ? Sign::zero : sites_.orient(q, s, z);
      if (side == Sign::zero && z != s) return false;
      if (side != Sign::positive) insertion.right.push_back({z, next(entered)});
      if (side != Sign::negative) {
        left.back().edge = prev(entered);
        left.push_back({z, PlanarMesh::none});
      }
      if (z == s) break;
      crossed = side == Sign::positive ? next(entered) : prev(entered);
    }
    insertion.left.assign(left.rbegin(), left.rend());
    return true;
  }

  /// Cuts ears with angles smaller than the worst from both polygons. False where something is left.
  bool fill(Insertion& insertion, const Triangle& worst) {
    return fill(insertion.right, insertion, worst) && fill(insertion.left, insertion, worst);
  }
  /// Each vertex of the chain saw the new edge along an edge that was crossed, between those of its
  /// neighbours: a convex corner is an ear, without a look at the other vertices. An ear that is not cut is
  /// looked at again when a neighbour was.
  bool fill(std::vector<Link>& chain, Insertion& insertion, const Triangle& worst) {
    std::vector<Link> open;
    for (const Link& link : chain) {
      open.push_back(link);
      while (open.size() >= 3) {
        const Link c = open.back(), b = open[open.size() - 2], a = open[open.size() - 3];
        if (!is_good_ear(a.vertex, b.vertex, c.vertex, worst)) break;
        const Index slot = insertion.crossed[insertion.ears.size()];
        insertion.ears.push_back({slot, a, b, c});
        open.resize(open.size() - 2);
        open.push_back({c.vertex, 3 * slot + 1, true});
      }
    }
    chain = std::move(open);
    return chain.size() == 2;
  }
  bool is_good_ear(Index a, Index b, Index c, const Triangle& worst) {
    ++counts_.ears;
    return sites_.orient(a, b, c) == Sign::positive &&
           sites_.compare_angle(largest_corner(sites_, {a, b, c}), worst) == Sign::negative;
  }

  void commit(const Insertion& insertion) {
    ++counts_.insertions;
    std::vector<std::pair<HalfEdge, HalfEdge>> sides;  // of the polygons: old name, twin
    for (const Ear& ear : insertion.ears)
      for (const Link& link : {ear.b, ear.c})
        if (!link.cut) sides.emplace_back(link.edge, mesh_.twin(link.edge));
    for (const Ear& ear : insertion.ears) {
      mesh_.replace(ear.slot, ear.a.vertex, ear.b.vertex, ear.c.vertex);
      take_side(ear.b, 3 * ear.slot + 2);
      take_side(ear.c, 3 * ear.slot);
    }
    // Where both triangles of a side were to go, it has two names and both have changed.
    for (const auto& [side, twin] : sides)
      mesh_.glue(renamed_[side],
                 twin < renamed_.size() && renamed_[twin] != PlanarMesh::none ? renamed_[twin] : twin);
    mesh_.glue(insertion.right.back().edge, insertion.left.back().edge);
    for (const auto& [side, twin] : sides) renamed_[side] = PlanarMesh::none;
    for (const Ear& ear : insertion.ears) note_largest_corner(ear.slot);
  }
  void take_side(const Link& link, HalfEdge side) {
    if (link.cut)
      mesh_.glue(link.edge, side);
    else
      renamed_[link.edge] = side;
  }

  Sites sites_;
  PlanarMesh mesh_;
  Index finite_;  ///< triangles; ghosts come behind them
  std::vector<Index> vertices_;
  std::vector<std::uint32_t> stamps_;  ///< by triangle
  std::vector<HalfEdge> renamed_;      ///< by half-edge, while an insertion is committed
  std::priority_queue<Corner, std::vector<Corner>, std::function<bool(const Corner&, const Corner&)>> worst_;
  std::unordered_set<std::uint64_t> hopeless_;  ///< edges of no better triangulation, by their ends
  EdgeInsertionCounts counts_;
};

}  // namespace

EdgeInsertionResult insert_edges_for_min_max_angle(const Sites& sites, std::span<const Triangle> triangles) {
  if (triangles.empty()) return {};
  return EdgeInserter(sites, triangles).run();
}

}  // namespace tribunal
