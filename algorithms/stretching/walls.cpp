#include "algorithms/stretching/walls.hpp"

#include <cmath>

namespace tribunal::stretching {
namespace {
using constrained::Mesh;

/// The vertices that held edges join to the hull.
std::vector<char> joined_to_hull(const Mesh& mesh) {
  const PlanarMesh& t = mesh.triangles();
  std::vector<char> joined(mesh.vertices(), 0);
  std::vector<Index> front;
  const auto reach = [&](Index vertex) {
    if (joined[vertex] != 0) return;
    joined[vertex] = 1;
    front.push_back(vertex);
  };
  for (Index ghost = 0; ghost < t.triangles(); ++ghost)
    if (const HalfEdge hull_edge = t.ghost_corner(ghost); hull_edge != PlanarMesh::none) {
      reach(t.from(hull_edge));
      reach(t.to(hull_edge));
    }
  while (!front.empty()) {
    const HalfEdge first = mesh.link(front.back());
    front.pop_back();
    HalfEdge h = first;
    do {
      if (mesh.held(prev(h))) reach(t.from(h));
      h = mesh.next_link(h);
    } while (h != first);
  }
  return joined;
}

template <class Visit>
void for_boundary(const Mesh& mesh, Visit visit) {
  const PlanarMesh& t = mesh.triangles();
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h) {
    const HalfEdge g = t.twin(h);
    if (h < g && mesh.held(h) && (mesh.inside(triangle_of(h)) || mesh.inside(triangle_of(g))))
      visit(t.from(h), t.to(h));
  }
}

Vector unit(Vector v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1]);
  return {v[0] / length, v[1] / length};
}
Vector sum(Vector u, Vector v) { return {u[0] + v[0], u[1] + v[1]}; }
double dot(Vector u, Vector v) { return u[0] * v[0] + u[1] * v[1]; }

/// Between two unit vectors along held edges, the domain counter-clockwise from the first to the second.
void add_ways(Vector first, Vector second, std::vector<Vector>& ways) {
  const double turn = first[0] * second[1] - first[1] * second[0], cosine = dot(first, second);
  const Vector from{-first[1], first[0]}, to{second[1], -second[0]};  // the normals
  if (turn > 0 && cosine > 0) {
    ways.push_back(unit(sum(first, second)));
    return;
  }
  const Vector bisector =
      turn > 0 || cosine < 0 ? unit(sum(from, to)) : unit({-first[0] - second[0], -first[1] - second[1]});
  const double between = dot(from, to);
  if (turn > 0 || between > 0.5) {
    ways.push_back(bisector);
    return;
  }
  ways.push_back(from);
  if (between <= -0.5) ways.push_back(bisector);
  ways.push_back(to);
}

}  // namespace

Boundary boundary_of(const Mesh& mesh, WallChoice choice) {
  std::vector<char> outer(mesh.vertices(), 0);
  if (choice == WallChoice::inner) outer = joined_to_hull(mesh);
  Boundary boundary{{}, {}, std::vector<char>(mesh.vertices(), 0)};
  for_boundary(mesh, [&](Index a, Index b) {
    const bool wall = outer[a] == 0;
    (wall ? boundary.walls : boundary.rim).push_back({mesh.point(a), mesh.point(b)});
    if (wall) boundary.on_wall[a] = boundary.on_wall[b] = 1;
  });
  return boundary.walls.empty() && choice == WallChoice::inner ? boundary_of(mesh, WallChoice::all)
                                                               : boundary;
}

std::vector<Vector> ways_from(const Mesh& mesh, Index vertex) {
  const PlanarMesh& t = mesh.triangles();
  const Point2 at = mesh.point(vertex);
  const auto towards = [&](Index other) {
    const Point2 p = mesh.point(other);
    return unit({p[0] - at[0], p[1] - at[1]});
  };
  std::vector<Vector> ways;
  const HalfEdge first = mesh.link(vertex);
  HalfEdge h = first;
  do {
    if (mesh.held(prev(h)) && mesh.inside(triangle_of(h))) {
      HalfEdge last = h;
      while (!mesh.held(next(last))) last = mesh.next_link(last);
      add_ways(towards(t.from(h)), towards(t.to(last)), ways);
    }
    h = mesh.next_link(h);
  } while (h != first);
  return ways;
}

}  // namespace tribunal::stretching
