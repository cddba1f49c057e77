// A planar triangulation as corners and twins: topology only, no coordinates and no decisions.
#pragma once

#include "algorithms/abandon.hpp"
#include "algorithms/triangulation.hpp"

#include <cassert>
#include <vector>

namespace tribunal {

/// The vertex at infinity. Every hull edge has one ghost triangle (infinite, u, v) on its outer side, so that
/// each edge has two triangles and the mesh is a topological sphere: no far-away super-triangle, no special
/// case at the hull.
inline constexpr Index infinite = 0xFFFFFFFF;

/// Half-edge h = 3 t + i is the edge of triangle t opposite its corner i; it runs counter-clockwise around t
/// from corner(next(h)) to corner(prev(h)). Its twin is the same edge seen from the other side.
using HalfEdge = Index;

constexpr HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr HalfEdge prev(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
constexpr Index triangle_of(HalfEdge h) { return h / 3; }

class PlanarMesh {
 public:
  Index triangles() const { return static_cast<Index>(corners_.size() / 3); }
  void reserve(std::size_t triangles) {
    corners_.reserve(3 * triangles);
    twins_.reserve(3 * triangles);
  }

  /// The vertex opposite half-edge h, in its triangle.
  Index corner(HalfEdge h) const { return corners_[h]; }
  Index from(HalfEdge h) const { return corners_[next(h)]; }
  Index to(HalfEdge h) const { return corners_[prev(h)]; }
  HalfEdge twin(HalfEdge h) const { return twins_[h]; }
  Triangle triangle(Index t) const { return {corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]}; }

  bool is_ghost(Index t) const { return ghost_corner(t) != none; }
  /// The half-edge of ghost t that is its hull edge, i.e. the one opposite the vertex at infinity; `none` if
  /// t is finite.
  HalfEdge ghost_corner(Index t) const {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (corners_[h] == infinite) return h;
    return none;
  }

  /// Appends a triangle with no twins yet. Abandons where 32-bit half-edges end, at 1.4e9 triangles.
  Index add(Index a, Index b, Index c) {
    if (corners_.size() >= none - 3)
      throw Abandon(Outcome::refused_input, "more triangles than 32-bit half-edges can name");
    corners_.insert(corners_.end(), {a, b, c});
    twins_.insert(twins_.end(), {none, none, none});
    return triangles() - 1;
  }
  /// Overwrites the corners of t; its twins are to be glued anew.
  void replace(Index t, Index a, Index b, Index c) {
    corners_[3 * t] = a;
    corners_[3 * t + 1] = b;
    corners_[3 * t + 2] = c;
  }
  /// Names another vertex opposite half-edge h.
  void set_corner(HalfEdge h, Index vertex) { corners_[h] = vertex; }
  void glue(HalfEdge g, HalfEdge h) {
    twins_[g] = h;
    twins_[h] = g;
  }

  static constexpr HalfEdge none = 0xFFFFFFFF;

 private:
  std::vector<Index> corners_;
  std::vector<HalfEdge> twins_;
};

/// Appends abc (counter-clockwise) with its three ghosts, glued: the whole plane in four triangles. The
/// finite one is the first of the four.
inline Index add_first_triangle(PlanarMesh& mesh, Index a, Index b, Index c) {
  const Index t = mesh.add(a, b, c);
  const Triangle corners{a, b, c};
  for (Index i = 0; i < 3; ++i)
    mesh.glue(3 * t + i, 3 * mesh.add(infinite, corners[(i + 2) % 3], corners[(i + 1) % 3]));
  for (Index i = 0; i < 3; ++i) {
    // The ghost across from corner i is (infinite, v, u) for the edge uv; it meets the next ghost at the
    // spoke of v.
    const Index ghost = t + 1 + i, following = t + 1 + (i + 1) % 3;
    mesh.glue(3 * ghost + 2, 3 * following + 1);
  }
  return t;
}

}  // namespace tribunal
