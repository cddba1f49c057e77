#include "algorithms/constrained/domain.hpp"

#include "algorithms/location/stochastic_walk.hpp"

#include <algorithm>
#include <numeric>

namespace tribunal::constrained {
namespace {

/// Takes the triangles reached from those of `front` across free edges out of the domain.
void remove_region(const Mesh& mesh, std::vector<Index> front, std::vector<bool>& inside) {
  for (const Index t : front) inside[t] = false;
  while (!front.empty()) {
    const Index t = front.back();
    front.pop_back();
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Index beyond = triangle_of(mesh.triangles().twin(h));
      if (mesh.held(h) || !inside[beyond]) continue;
      inside[beyond] = false;
      front.push_back(beyond);
    }
  }
}

std::vector<Index> ghosts(const Mesh& mesh) {
  std::vector<Index> found;
  for (Index t = 0; t < mesh.triangles().triangles(); ++t)
    if (mesh.triangles().is_ghost(t)) found.push_back(t);
  return found;
}

/// The vertices' positions, then those of the holes.
std::vector<Point2> positions(const Mesh& mesh, std::span<const Point2> holes) {
  std::vector<Point2> points;
  points.reserve(mesh.vertices() + holes.size());
  for (Index v = 0; v < mesh.vertices(); ++v) points.push_back(mesh.point(v));
  points.insert(points.end(), holes.begin(), holes.end());
  return points;
}

/// Whether p is in the box around the vertices.
class Box {
 public:
  explicit Box(const Mesh& mesh) : low_(mesh.point(0)), high_(low_) {
    for (Index v = 1; v < mesh.vertices(); ++v)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low_[axis] = std::min(low_[axis], mesh.point(v)[axis]);
        high_[axis] = std::max(high_[axis], mesh.point(v)[axis]);
      }
  }
  bool holds(Point2 p) const {
    return low_[0] <= p[0] && p[0] <= high_[0] && low_[1] <= p[1] && p[1] <= high_[1];
  }

 private:
  Point2 low_, high_;
};

bool touches_held(const Mesh& mesh, Index vertex) {
  const HalfEdge first = mesh.link(vertex);
  HalfEdge h = first;
  do {
    if (mesh.held(prev(h))) return true;
    h = mesh.next_link(h);
  } while (h != first);
  return false;
}

/// Whether p, which the triangle holds, lies on a held edge or at a vertex of one.
bool on_segment(const Mesh& mesh, Index t, Point2 p) {
  const PlanarMesh& triangles = mesh.triangles();
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
    const Index from = triangles.from(h), to = triangles.to(h);
    if (mesh.kernel().orient2d(mesh.point(from), mesh.point(to), p) != Sign::zero) continue;
    if (mesh.held(h)) return true;
    for (const Index end : {from, to})
      if (mesh.point(end) == p) return touches_held(mesh, end);
  }
  return false;
}

/// The finite triangle that holds each hole. Walks from hole to hole, from left to right. Throws NoHole for
/// one outside the hull or on a segment.
std::vector<Index> triangles_around(const Mesh& mesh, std::span<const Point2> holes) {
  std::vector<Index> order(holes.size()), found(holes.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return holes[a] < holes[b]; });
  const std::vector<Point2> points = positions(mesh, holes);
  const PlanarProblem problem{points, {}, mesh.kernel()};
  StochasticWalk walk(problem, mesh.triangles());
  const Box box(mesh);
  std::uint64_t steps = 0;
  for (const Index hole : order) {
    const std::string name = "hole " + std::to_string(hole);
    if (!box.holds(holes[hole])) throw NoHole(hole, name + " lies outside the domain");
    if (!mesh.kernel().admits(holes[hole]))
      throw NoHole(hole, name + " is outside the backend's domain", Outcome::out_of_domain);
    found[hole] = walk.locate(mesh.vertices() + hole, steps);
    if (mesh.triangles().is_ghost(found[hole])) throw NoHole(hole, name + " lies outside the domain");
    if (on_segment(mesh, found[hole], holes[hole])) throw NoHole(hole, name + " lies on a segment");
  }
  return found;
}

/// At each vertex, how many edges there count.
template <class Counts>
std::vector<Index> held_edges_at(const Mesh& mesh, Counts counts) {
  const PlanarMesh& t = mesh.triangles();
  std::vector<Index> edges(mesh.vertices(), 0);
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h)
    if (h < t.twin(h) && counts(h))
      for (const Index end : {t.from(h), t.to(h)}) ++edges[end];
  return edges;
}

/// Refuses vertices where that many edges leave a loop open.
template <class IsEnd>
void require_no_ends(const std::vector<Index>& edges_at, IsEnd is_end) {
  std::vector<Index> ends;
  for (Index v = 0; v < edges_at.size(); ++v)
    if (is_end(edges_at[v])) ends.push_back(v);
  if (!ends.empty()) throw OpenLoop(std::move(ends));
}

std::vector<bool> carve(const Mesh& mesh, const Graph& graph) {
  std::vector<bool> inside(mesh.triangles().triangles(), true);
  remove_region(mesh, ghosts(mesh), inside);
  if (std::find(inside.begin(), inside.end(), true) == inside.end()) {
    require_no_ends(held_edges_at(mesh, [&](HalfEdge h) { return mesh.held(h); }),
                    [](Index n) { return n == 1; });
    throw Abandon(Outcome::refused_input, "no segments close a loop: the outside reaches every triangle");
  }
  const std::vector<bool> enclosed = inside;
  const std::vector<Index> around = triangles_around(mesh, graph.holes);
  for (Index hole = 0; hole < around.size(); ++hole) {
    if (!enclosed[around[hole]])
      throw NoHole(hole, "hole " + std::to_string(hole) + " lies outside the domain");
    if (inside[around[hole]]) remove_region(mesh, {around[hole]}, inside);
  }
  return inside;
}

bool odd(const Mesh& mesh, const Recovered& recovered, HalfEdge h) {
  return mesh.held(h) && recovered.pieces[mesh.piece(h)].segments % 2 == 1;
}

/// Labels spread from the ghosts and change across odd edges. Loops being closed, every way to a triangle
/// gives it the same label.
std::vector<bool> count_crossings(const Mesh& mesh, const Recovered& recovered) {
  const auto counts = [&](HalfEdge h) { return odd(mesh, recovered, h); };
  require_no_ends(held_edges_at(mesh, counts), [](Index n) { return n % 2 == 1; });
  const PlanarMesh& t = mesh.triangles();
  std::vector<bool> inside(t.triangles(), false), seen(t.triangles(), false);
  std::vector<Index> front = ghosts(mesh);
  for (const Index ghost : front) seen[ghost] = true;
  while (!front.empty()) {
    const Index from = front.back();
    front.pop_back();
    for (HalfEdge h = 3 * from; h < 3 * from + 3; ++h) {
      const Index to = triangle_of(t.twin(h));
      if (seen[to]) continue;
      seen[to] = true;
      inside[to] = inside[from] != odd(mesh, recovered, h);
      front.push_back(to);
    }
  }
  if (std::find(inside.begin(), inside.end(), true) == inside.end())
    throw Abandon(Outcome::refused_input, "the segments enclose nothing");
  return inside;
}

}  // namespace

std::vector<bool> find_domain(const Mesh& mesh, const Recovered& recovered, const Graph& graph) {
  if (graph.domain == Domain::carved) return carve(mesh, graph);
  if (graph.domain == Domain::even_odd) return count_crossings(mesh, recovered);
  std::vector<bool> inside(mesh.triangles().triangles(), true);
  for (const Index ghost : ghosts(mesh)) inside[ghost] = false;
  return inside;
}

}  // namespace tribunal::constrained
