#include "algorithms/constrained/domain.hpp"

#include <algorithm>

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

/// Whether p may lie in the triangle: whether it is in its box.
bool in_box(Point2 p, Point2 a, Point2 b, Point2 c) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax({a[axis], b[axis], c[axis]});
    if (p[axis] < low || high < p[axis]) return false;
  }
  return true;
}

/// The finite triangle that holds p, or `none`. Refuses p on a held edge.
Index triangle_around(const Mesh& mesh, Point2 p, Index hole, const std::string& name) {
  const PlanarMesh& triangles = mesh.triangles();
  for (Index t = 0; t < triangles.triangles(); ++t) {
    if (triangles.is_ghost(t)) continue;
    const Triangle v = triangles.triangle(t);
    if (!in_box(p, mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]))) continue;
    if (!mesh.kernel().admits(p))
      throw NoHole(hole, name + " is outside the backend's domain", Outcome::out_of_domain);
    bool holds = true, on_segment = false;
    for (HalfEdge h = 3 * t; h < 3 * t + 3 && holds; ++h) {
      const Sign side = mesh.kernel().orient2d(mesh.point(triangles.from(h)), mesh.point(triangles.to(h)), p);
      holds = side != Sign::negative;
      on_segment |= side == Sign::zero && mesh.held(h);
    }
    if (holds && on_segment) throw NoHole(hole, name + " lies on a segment");
    if (holds) return t;
  }
  return PlanarMesh::none;
}

std::vector<bool> carve(const Mesh& mesh, const Graph& graph) {
  std::vector<bool> inside(mesh.triangles().triangles(), true);
  remove_region(mesh, ghosts(mesh), inside);
  if (std::find(inside.begin(), inside.end(), true) == inside.end())
    throw Abandon(Outcome::refused_input, "no segments close a loop: the outside reaches every triangle");
  const std::vector<bool> enclosed = inside;
  for (Index hole = 0; hole < graph.holes.size(); ++hole) {
    const std::string name = "hole " + std::to_string(hole);
    const Index t = triangle_around(mesh, graph.holes[hole], hole, name);
    if (t == PlanarMesh::none || !enclosed[t]) throw NoHole(hole, name + " lies outside the domain");
    if (inside[t]) remove_region(mesh, {t}, inside);
  }
  return inside;
}

bool odd(const Mesh& mesh, const Recovered& recovered, HalfEdge h) {
  return mesh.held(h) && recovered.pieces[mesh.piece(h)].segments % 2 == 1;
}

/// Refuses where a vertex ends an odd number of odd edges: they then bound nothing.
void require_closed_loops(const Mesh& mesh, const Recovered& recovered) {
  const PlanarMesh& t = mesh.triangles();
  std::vector<bool> ends_odd(mesh.vertices(), false);
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h)
    if (h < t.twin(h) && odd(mesh, recovered, h))
      for (const Index end : {t.from(h), t.to(h)}) ends_odd[end] = !ends_odd[end];
  const auto open = std::find(ends_odd.begin(), ends_odd.end(), true);
  if (open != ends_odd.end()) throw OpenLoop(static_cast<Index>(open - ends_odd.begin()));
}

/// Labels spread from the ghosts and change across odd edges. Loops being closed, every way to a triangle
/// gives it the same label.
std::vector<bool> count_crossings(const Mesh& mesh, const Recovered& recovered) {
  require_closed_loops(mesh, recovered);
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
