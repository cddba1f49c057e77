#include "algorithms/constrained/mesh.hpp"

#include "algorithms/insertion/conflict.hpp"
#include "algorithms/insertion/first_triangle.hpp"
#include "algorithms/location/walk.hpp"

#include <cassert>

namespace tribunal::constrained {

Mesh::Mesh(const Kernel2& kernel, Point2 a, Point2 b, Point2 c)
    : kernel_(kernel), points_{a, b, c}, incident_(3, 0), counters_(first_counters()) {
  const bool clockwise = kernel.orient2d(a, b, c) == Sign::negative;
  last_ = clockwise ? add_first_triangle(mesh_, 0, 2, 1) : add_first_triangle(mesh_, 0, 1, 2);
  pieces_.assign(3 * std::size_t{mesh_.triangles()}, free_edge);
  inside_.assign(mesh_.triangles(), 1);
}

void Mesh::reserve(std::size_t vertices) {
  points_.reserve(vertices);
  incident_.reserve(vertices);
  mesh_.reserve(2 * vertices);
  pieces_.reserve(6 * vertices);
  inside_.reserve(2 * vertices);
}

bool Mesh::swappable(HalfEdge h) const {
  const HalfEdge g = mesh_.twin(h);
  const Index s = mesh_.corner(h), p = mesh_.corner(g);
  if (s == infinite || p == infinite || s == p) return false;
  return side(s, mesh_.from(h), p) == Sign::positive && side(s, p, mesh_.to(h)) == Sign::positive;
}

bool Mesh::violates(HalfEdge h) const {
  const Triangle t = mesh_.triangle(triangle_of(h));
  const Index across = mesh_.corner(mesh_.twin(h));
  if (across == infinite || mesh_.is_ghost(triangle_of(h))) return false;
  return kernel_.incircle(points_[t[0]], points_[t[1]], points_[t[2]], points_[across]) == Sign::positive;
}

HalfEdge Mesh::link(Index vertex) const {
  HalfEdge h = 3 * incident_[vertex];
  while (mesh_.corner(h) != vertex) ++h;
  return h;
}

HalfEdge Mesh::edge(Index a, Index b) const {
  const HalfEdge first_at_a = link(a), first_at_b = link(b);
  HalfEdge g = first_at_a, h = first_at_b;
  do {
    if (mesh_.from(g) == b) return prev(g);
    if (mesh_.to(h) == a) return next(h);
    g = next_link(g);
    h = next_link(h);
  } while (g != first_at_a && h != first_at_b);
  return PlanarMesh::none;
}

Index Mesh::insert(Point2 position) {
  const Index vertex = add_vertex(position);
  const PlanarProblem problem{points_, {}, kernel_};
  const Index t = walk(problem, mesh_, last_, vertex, counters_.location_steps);
  on_hull_ = mesh_.is_ghost(t);
  const HalfEdge edge = on_hull_ ? PlanarMesh::none : edge_through(t, vertex);
  if (edge == PlanarMesh::none)
    split_triangle(t, vertex);
  else
    split_edge(edge, vertex);
  legalise(problem, vertex);
  last_ = incident_[vertex];
  return vertex;
}

void Mesh::confine(std::vector<char> inside) {
  assert(inside.size() == mesh_.triangles());
  inside_ = std::move(inside);
}

Index Mesh::insert_into(Index t, Point2 position) {
  const Index vertex = add_vertex(position);
  on_hull_ = false;
  split_triangle(t, vertex);
  legalise({points_, {}, kernel_}, vertex);
  return vertex;
}

Index Mesh::insert_on(HalfEdge h, Point2 position) {
  const Index vertex = add_vertex(position);
  split_edge(h, vertex);
  legalise({points_, {}, kernel_}, vertex);
  return vertex;
}

Index Mesh::place_into(Index t, Point2 position) {
  const Index vertex = add_vertex(position);
  split_triangle(t, vertex);
  suspects_.clear();
  return vertex;
}

Index Mesh::place_on(HalfEdge h, Point2 position) {
  const Index vertex = add_vertex(position);
  split_edge(h, vertex);
  suspects_.clear();
  return vertex;
}

Index Mesh::add_vertex(Point2 position) {
  points_.push_back(position);
  incident_.push_back(0);
  return vertices() - 1;
}

/// The edge of the finite triangle t on which the vertex lies, or `none` when it lies inside.
HalfEdge Mesh::edge_through(Index t, Index vertex) const {
  HalfEdge edge = PlanarMesh::none;
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
    const Sign sign = side(mesh_.from(h), mesh_.to(h), vertex);
    if (sign == Sign::negative || (sign == Sign::zero && edge != PlanarMesh::none))
      throw Abandon(Outcome::inconsistent_predicate,
                    "a site does not lie in the triangle where it was located");
    if (sign == Sign::zero) edge = h;
  }
  return edge;
}

/// Adds a triangle on the same side of the domain's boundary as another one.
Index Mesh::add_triangle(Index a, Index b, Index c, Index beside) {
  const char side = inside_[beside];
  if (!discarded_.empty()) {
    const Index t = discarded_.back();
    discarded_.pop_back();
    mesh_.replace(t, a, b, c);
    inside_[t] = side;
    return t;
  }
  const Index t = mesh_.add(a, b, c);
  pieces_.insert(pieces_.end(), 3, free_edge);
  inside_.push_back(side);
  return t;
}

void Mesh::discard(Index t) {
  mesh_.replace(t, infinite, infinite, infinite);
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) pieces_[h] = free_edge;
  inside_[t] = 0;
  discarded_.push_back(t);
}

void Mesh::replace(Index t, Index a, Index b, Index c) {
  mesh_.replace(t, a, b, c);
  touch(a, t);
  touch(b, t);
  touch(c, t);
}

/// One triangle, or one ghost, becomes the three of the star of `vertex`.
void Mesh::split_triangle(Index t, Index vertex) {
  const Triangle corner = mesh_.triangle(t);
  const Triangle beyond{mesh_.twin(3 * t), mesh_.twin(3 * t + 1), mesh_.twin(3 * t + 2)};
  const Triangle child{t, add_triangle(vertex, corner[2], corner[0], t),
                       add_triangle(vertex, corner[0], corner[1], t)};
  replace(t, vertex, corner[1], corner[2]);
  touch(corner[0], child[1]);
  for (Index i = 0; i < 3; ++i) {
    attach(3 * child[i], beyond[i]);
    suspects_.push_back(child[i]);
  }
  for (Index i = 0; i < 3; ++i) join(3 * child[i] + 1, 3 * child[(i + 1) % 3] + 2);
  counters_.created += 3;
}

/// The two triangles of an edge become the four of the star of a vertex on it; both halves keep the edge's
/// piece.
void Mesh::split_edge(HalfEdge h, Index vertex) {
  const HalfEdge g = mesh_.twin(h);
  const Index held_by = pieces_[h];
  const Index left = triangle_of(h), far_left = triangle_of(g);
  on_hull_ = mesh_.is_ghost(left) || mesh_.is_ghost(far_left);
  const Index a = mesh_.from(h), b = mesh_.to(h), p = mesh_.corner(h), q = mesh_.corner(g);
  const HalfEdge beyond_pa = mesh_.twin(prev(h)), beyond_bp = mesh_.twin(next(h));
  const HalfEdge beyond_qb = mesh_.twin(prev(g)), beyond_aq = mesh_.twin(next(g));
  const Index right = add_triangle(vertex, b, p, left);
  const Index far_right = add_triangle(vertex, a, q, far_left);
  replace(left, vertex, p, a);
  replace(far_left, vertex, q, b);
  attach(3 * left, beyond_pa);
  attach(3 * right, beyond_bp);
  attach(3 * far_left, beyond_qb);
  attach(3 * far_right, beyond_aq);
  join(3 * left + 2, 3 * right + 1);
  join(3 * far_left + 2, 3 * far_right + 1);
  join(3 * left + 1, 3 * far_right + 2);
  join(3 * far_left + 1, 3 * right + 2);
  if (held_by != free_edge) {
    hold(3 * left + 1, held_by);
    hold(3 * far_left + 1, held_by);
  }
  suspects_.insert(suspects_.end(), {left, right, far_left, far_right});
  counters_.created += 4;
  ++counters_.on_edge;
}

/// Swaps edges opposite the new vertex until none is in conflict. Each swap adds one triangle to the star,
/// and no vertex joins a star twice when the signs are right.
void Mesh::legalise(const PlanarProblem& problem, Index vertex) {
  Budget budget(std::uint64_t{vertices()} + 1, "swapping");
  std::uint64_t star = suspects_.size();
  while (!suspects_.empty()) {
    const Index t = suspects_.back();
    suspects_.pop_back();
    if (held(3 * t) || !inside(t)) continue;
    const HalfEdge across = mesh_.twin(3 * t);
    ++counters_.conflict_tests;
    if (!in_conflict(problem, mesh_.triangle(triangle_of(across)), vertex)) continue;
    budget.spend();
    if (mesh_.corner(across) == infinite || mesh_.corner(across) == vertex)
      throw Abandon(Outcome::inconsistent_predicate, "a swap would join a site to infinity or to itself");
    const Index other = triangle_of(across);
    swap(3 * t);
    suspects_.insert(suspects_.end(), {t, other});
    ++star;
    ++counters_.flips;
    counters_.created += 2;
  }
  counters_.tau_with_ghosts += star;
  counters_.tau += star - (on_hull_ ? 2 : 0);
  counters_.outside_hull += on_hull_;
}

/// (s, a, b) and (p, b, a) become (s, a, p) and (s, p, b), s at corner 0 of both.
void Mesh::swap(HalfEdge h) {
  const HalfEdge g = mesh_.twin(h);
  const Index t = triangle_of(h), o = triangle_of(g);
  const Index s = mesh_.corner(h), p = mesh_.corner(g), a = mesh_.from(h), b = mesh_.to(h);
  const HalfEdge beyond_sa = mesh_.twin(prev(h)), beyond_bs = mesh_.twin(next(h));
  const HalfEdge beyond_ap = mesh_.twin(next(g)), beyond_pb = mesh_.twin(prev(g));
  mesh_.replace(t, s, a, p);
  mesh_.replace(o, s, p, b);
  attach(3 * t, beyond_ap);
  attach(3 * t + 2, beyond_sa);
  attach(3 * o, beyond_pb);
  attach(3 * o + 1, beyond_bs);
  join(3 * t + 1, 3 * o + 2);
  touch(a, t);
  touch(b, o);
}

std::uint64_t Mesh::restore(std::vector<Edge> suspects) {
  // No swap brings an edge back, so there are fewer than pairs of vertices of what was torn up.
  const std::uint64_t around = suspects.size() + 8;
  Budget budget(around * around, "restoring circles");
  std::uint64_t swaps = 0;
  while (!suspects.empty()) {
    const auto [a, b] = suspects.back();
    suspects.pop_back();
    const HalfEdge h = edge(a, b);
    if (h == PlanarMesh::none || held(h) || !violates(h)) continue;
    budget.spend();
    if (!swappable(h))
      throw Abandon(Outcome::inconsistent_predicate, "an edge violates its circle but cannot be swapped");
    const Index s = mesh_.corner(h), p = mesh_.corner(mesh_.twin(h));
    swap(h);
    ++swaps;
    suspects.insert(suspects.end(), {Edge{s, a}, Edge{a, p}, Edge{p, b}, Edge{b, s}});
  }
  return swaps;
}

}  // namespace tribunal::constrained
