#include "algorithms/greedy/constrained_mesh.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/flips/quadrilateral.hpp"

#include <deque>
#include <optional>
#include <string>

namespace tribunal {
namespace {

/// Walks along a segment and makes it an edge.
class Forcing {
 public:
  Forcing(const PlanarProblem& problem, ConstrainedMesh& constrained)
      : problem_(problem), constrained_(constrained), spoke_(problem.points.size(), PlanarMesh::none) {
    for (HalfEdge h = 0; h < 2 * mesh().edges(); ++h) spoke_[mesh().from(h)] = h;
  }

  /// The segment's edge, locked.
  Index force(const Edge& segment) {
    Index edge = 0;
    if (const auto there = find_crossings(segment)) {
      edge = *there;
    } else {
      flip_crossings(segment);
      edge = edge_between(segment);
    }
    constrained_.lock(edge);
    constrained_.restore(region_);
    for (const Index flipped : region_) note_spokes(flipped);
    return edge;
  }

 private:
  const EdgeMesh& mesh() const { return constrained_.mesh(); }
  Sign turn(Index a, Index b, Index c) const {
    const auto& p = problem_.points;
    return problem_.kernel.orient2d(p[a], p[b], p[c]);
  }

  [[noreturn]] static void refuse(const Edge& segment) {
    throw Abandon(Outcome::refused_input, "the given edge " + std::to_string(segment[0]) + "-" +
                                              std::to_string(segment[1]) +
                                              " meets a site or another given edge");
  }

  /// The segment's edge where it is in the mesh; else fills region_ with what the segment crosses.
  std::optional<Index> find_crossings(const Edge& segment) {
    region_.clear();
    const auto [a, b] = segment;
    HalfEdge across = PlanarMesh::none;
    HalfEdge h = spoke_[a];
    do {
      if (mesh().to(h) == b) return EdgeMesh::edge_of(h);
      const HalfEdge following = mesh().next_counter_clockwise(h);
      if (!mesh().is_outer(h) && turn(a, mesh().to(h), b) == Sign::positive &&
          turn(a, b, mesh().to(following)) == Sign::positive)
        across = mesh().next(h);
      h = following;
    } while (h != spoke_[a]);
    if (across == PlanarMesh::none) refuse(segment);
    Budget budget(mesh().edges(), "the walk along a given edge");
    for (;;) {
      budget.spend();
      if (constrained_.is_locked(EdgeMesh::edge_of(across)) || !mesh().is_inner(EdgeMesh::edge_of(across)))
        refuse(segment);
      region_.push_back(EdgeMesh::edge_of(across));
      const HalfEdge beyond = EdgeMesh::twin(across);
      const Index apex = mesh().apex(beyond);
      if (apex == b) return std::nullopt;
      const Sign side = turn(a, b, apex);
      if (side == Sign::zero) refuse(segment);
      // `beyond` starts on the left of ab: what leaves the triangle there has its ends on both sides, too.
      across = side == Sign::positive ? mesh().next(beyond) : mesh().prev(beyond);
    }
  }

  bool crosses(Index edge, const Edge& segment) const {
    const Index c = mesh().from(2 * edge), d = mesh().to(2 * edge);
    return turn(segment[0], segment[1], c) * turn(segment[0], segment[1], d) == Sign::negative;
  }

  void flip_crossings(const Edge& segment) {
    std::deque<Index> crossings(region_.begin(), region_.end());
    Budget budget(2 * crossings.size() * crossings.size() + 16, "the forcing of an edge");
    while (!crossings.empty()) {
      budget.spend();
      const Index edge = crossings.front();
      crossings.pop_front();
      if (is_strictly_convex({problem_.points, problem_.kernel}, quadrilateral(mesh(), edge))) {
        constrained_.flip(edge);
        note_spokes(edge);
      }
      if (crosses(edge, segment)) crossings.push_back(edge);
    }
  }

  /// A flip takes the edge from two vertices: all four around it get a spoke that is theirs.
  void note_spokes(Index flipped) {
    for (const HalfEdge h : {HalfEdge{2 * flipped}, EdgeMesh::twin(2 * flipped)})
      for (const HalfEdge side : {mesh().next(h), mesh().prev(h)}) spoke_[mesh().from(side)] = side;
  }

  Index edge_between(const Edge& segment) const {
    HalfEdge h = spoke_[segment[0]];
    do {
      if (mesh().to(h) == segment[1]) return EdgeMesh::edge_of(h);
      h = mesh().next_counter_clockwise(h);
    } while (h != spoke_[segment[0]]);
    throw Abandon(Outcome::inconsistent_predicate, "flips did not make a given edge an edge of the mesh");
  }

  const PlanarProblem& problem_;
  ConstrainedMesh& constrained_;
  std::vector<HalfEdge> spoke_;  // by vertex: some half-edge that starts there
  std::vector<Index> region_;    // the edges that the segment crosses, or crossed before they flipped
};

}  // namespace

bool ConstrainedMesh::is_illegal(Index edge) {
  if (is_locked(edge) || !mesh_.is_inner(edge)) return false;
  ++circle_tests_;
  const Quadrilateral q = quadrilateral(mesh_, edge);
  return Sites{problem_.points, problem_.kernel}.incircle(q.from, q.to, q.left, q.right) == Sign::positive;
}

void ConstrainedMesh::restore(std::span<const Index> region) {
  std::vector<Index> suspects(region.begin(), region.end());
  for (const Index edge : region) in_region_[edge] = 1;
  // No edge that a flip removes ever returns, and k edges inside a polygon join k + 3 vertices.
  Budget budget((region.size() + 3) * (region.size() + 3), "the restoring of a Delaunay triangulation");
  while (!suspects.empty()) {
    const Index edge = suspects.back();
    suspects.pop_back();
    if (!is_illegal(edge)) continue;
    budget.spend();
    flip(edge);
    for (const HalfEdge h : {HalfEdge{2 * edge}, EdgeMesh::twin(2 * edge)})
      for (const HalfEdge side : {mesh_.next(h), mesh_.prev(h)})
        if (in_region_[EdgeMesh::edge_of(side)]) suspects.push_back(EdgeMesh::edge_of(side));
  }
  for (const Index edge : region) in_region_[edge] = 0;
}

std::vector<Index> ConstrainedMesh::force(std::span<const Edge> segments) {
  std::vector<Index> edges;
  if (segments.empty()) return edges;
  Forcing forcing(problem_, *this);
  for (const Edge& segment : segments) edges.push_back(forcing.force(segment));
  return edges;
}

}  // namespace tribunal
