#include "algorithms/greedy/from_delaunay.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/greedy/constrained_mesh.hpp"
#include "algorithms/greedy/domain.hpp"
#include "algorithms/greedy/length_order.hpp"
#include "algorithms/greedy/locked_spokes.hpp"

#include <queue>
#include <utility>

namespace tribunal {
namespace {

class Greedy {
 public:
  Greedy(const GreedyProblem& problem, std::span<const Triangle> delaunay)
      : problem_(problem.planar),
        order_(problem.planar),
        constrained_(problem.planar, delaunay),
        spokes_(constrained_.mesh()),
        waiting_(Later{&order_}) {
    std::vector<Edge> given(problem.boundary.begin(), problem.boundary.end());
    given.insert(given.end(), problem.constraints.begin(), problem.constraints.end());
    const std::vector<Index> edges = constrained_.force(given);
    find_outside(Domain(problem));
    for (const Index edge : edges) accept(edge);
    for (Index edge = 0; edge < mesh().edges(); ++edge) offer_edge(edge);
  }

  void run() {
    while (!waiting_.empty()) {
      const Waiting next = waiting_.top();
      waiting_.pop();
      ++result_.found.candidates;
      if (next.is_ear)
        cut(next);
      else if (ends_of(EdgeMesh::edge_of(next.at)) == next.candidate.ends)
        accept(EdgeMesh::edge_of(next.at));
    }
  }

  GreedyMesh result() && {
    for (Index edge = 0; edge < mesh().edges(); ++edge)
      if (!is_outside(edge) && !is_accepted(edge))
        throw Abandon(Outcome::inconsistent_predicate, "an edge of the mesh was no candidate");
    for (HalfEdge h = 0; h < outside_.size(); ++h) {
      const HalfEdge second = mesh().next(h), third = mesh().prev(h);
      const Triangle t{mesh().from(h), mesh().from(second), mesh().from(third)};
      if (!outside_[h] && t[0] < t[1] && t[0] < t[2]) result_.triangles.push_back(t);
    }
    result_.found.conflict_tests = constrained_.circle_tests();
    result_.flips = constrained_.flips();
    return std::move(result_);
  }

 private:
  /// A candidate: an edge of the mesh, as long as it has these ends, or an ear.
  struct Waiting {
    Candidate candidate;
    HalfEdge at;  ///< one of the edge's two; or the ear's first side, from its tip
    bool is_ear;
  };
  struct Later {
    const LengthOrder* order;
    bool operator()(const Waiting& a, const Waiting& b) const { return (*order)(b.candidate, a.candidate); }
  };

  const EdgeMesh& mesh() const { return constrained_.mesh(); }
  Edge ends_of(Index edge) const { return undirected(mesh().from(2 * edge), mesh().to(2 * edge)); }
  Sign turn(Index a, Index b, Index c) const {
    const auto& p = problem_.points;
    return problem_.kernel.orient2d(p[a], p[b], p[c]);
  }
  bool is_accepted(Index edge) const { return spokes_.contains(2 * edge); }
  bool is_outside(Index edge) const { return outside_[2 * edge] && outside_[2 * edge + 1]; }

  void find_outside(const Domain& domain) {
    outside_.resize(2 * std::size_t{mesh().edges()});
    for (HalfEdge h = 0; h < outside_.size(); ++h)
      outside_[h] = mesh().is_outer(h) || !domain.opens_after(mesh().from(h), mesh().to(h));
  }

  void offer_edge(Index edge) {
    if (is_accepted(edge) || is_outside(edge)) return;
    const auto [a, b] = ends_of(edge);
    waiting_.push({order_.candidate(a, b), 2 * edge, false});
  }

  void accept(Index edge) {
    if (is_accepted(edge)) return;
    constrained_.lock(edge);
    result_.found.edges.push_back(ends_of(edge));
    for (const HalfEdge h : {HalfEdge{2 * edge}, EdgeMesh::twin(2 * edge)}) {
      spokes_.insert(h);
      offer_ear(h);
      offer_ear(spokes_.preceding(h));
    }
  }

  /// Whether the ear that begins at `first` is empty is settled here for good: its corners and the sites do
  /// not move.
  void offer_ear(HalfEdge first) {
    const HalfEdge last = spokes_.following(first);
    const Index tip = mesh().from(first), a = mesh().to(first), b = mesh().to(last);
    if (outside_[first] || turn(tip, a, b) != Sign::positive) return;
    if (mesh().next_counter_clockwise(first) == last) return;  // ab is an edge of the mesh
    for (HalfEdge h = mesh().next_counter_clockwise(first); h != last; h = mesh().next_counter_clockwise(h)) {
      ++result_.found.search_steps;
      if (turn(a, b, mesh().to(h)) != Sign::negative) return;
    }
    waiting_.push({order_.candidate(a, b), first, true});
  }

  /// Makes the ear's base an edge. The spokes between its sides flip away one by one, as a scan for the hull
  /// of their ends drops these, and the last flip brings in the base.
  void cut(const Waiting& ear) {
    const HalfEdge first = ear.at, last = spokes_.following(first);
    if (undirected(mesh().to(first), mesh().to(last)) != ear.candidate.ends) return;
    std::vector<Index> flipped;
    HalfEdge h = mesh().next_counter_clockwise(first);
    while (h != last) {
      const HalfEdge before = mesh().next_clockwise(h), after = mesh().next_counter_clockwise(h);
      if (turn(mesh().to(before), mesh().to(after), mesh().to(h)) == Sign::negative) {
        flipped.push_back(EdgeMesh::edge_of(h));
        constrained_.flip(flipped.back());
        h = before == first ? after : before;
      } else {
        h = after;
      }
    }
    if (flipped.empty()) return;  // the base has become an edge of the mesh
    if (ends_of(flipped.back()) != ear.candidate.ends)
      throw Abandon(Outcome::inconsistent_predicate, "an ear that was empty is not");
    constrained_.lock(flipped.back());
    constrained_.restore(flipped);
    accept(flipped.back());
    for (const Index edge : flipped) offer_edge(edge);
  }

  const PlanarProblem& problem_;
  LengthOrder order_;
  ConstrainedMesh constrained_;
  LockedSpokes spokes_;
  std::priority_queue<Waiting, std::vector<Waiting>, Later> waiting_;
  std::vector<char> outside_;  // by half-edge: the face on its left is not in the domain
  GreedyMesh result_;
};

}  // namespace

GreedyMesh triangulate_from_delaunay(const GreedyProblem& problem, std::span<const Triangle> delaunay) {
  Greedy greedy(problem, delaunay);
  greedy.run();
  return std::move(greedy).result();
}

}  // namespace tribunal
