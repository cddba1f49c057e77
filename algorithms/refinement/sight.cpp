#include "algorithms/refinement/sight.hpp"

#include <array>
#include <optional>

namespace tribunal::refinement {
namespace {
using constrained::Mesh;

class Look {
 public:
  Look(const Mesh& mesh, Point2 p, std::uint64_t& steps)
      : mesh_(mesh),
        t_(mesh.triangles()),
        p_(p),
        steps_(steps),
        budget_(4 * std::uint64_t{t_.triangles()}, "looking") {}

  Sighting from(Index t) {
    const std::array<Sign, 3> sides = sides_of(t);
    for (Index i = 0; i < 3; ++i) {
      if (sides[i] != Sign::negative) continue;
      const HalfEdge h = 3 * t + i;
      if (sides[(i + 1) % 3] != Sign::positive) return past_vertex(prev(h));
      if (sides[(i + 2) % 3] == Sign::negative) return past_vertex(next(h));
      return straight(t_.corner(h), h);
    }
    return classify(t, sides);
  }

 private:
  /// Where p is, seen along the half-edge: positive on the side of its triangle.
  Sign side(HalfEdge h) const { return turn(t_.from(h), t_.to(h)); }
  Sign turn(Index a, Index b) const { return mesh_.kernel().orient2d(mesh_.point(a), mesh_.point(b), p_); }
  std::array<Sign, 3> sides_of(Index t) const { return {side(3 * t), side(3 * t + 1), side(3 * t + 2)}; }
  void step() {
    budget_.spend();
    ++steps_;
  }

  static Sighting classify(Index t, const std::array<Sign, 3>& sides) {
    HalfEdge on = PlanarMesh::none;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Sign side = sides[h - 3 * t];
      if (side == Sign::negative)
        throw Abandon(Outcome::inconsistent_predicate, "a point is not in the triangle where it was found");
      if (side == Sign::positive) continue;
      // Two edges meet at the corner opposite the third.
      if (on != PlanarMesh::none) return {Sighting::Kind::at_vertex, next(on) == h ? next(h) : next(on)};
      on = h;
    }
    if (on != PlanarMesh::none) return {Sighting::Kind::on_edge, on};
    return {Sighting::Kind::inside, 3 * t};
  }
  Sighting classify(Index t) const { return classify(t, sides_of(t)); }

  /// From a vertex through the edge h opposite it, beyond which p lies: the edge's end is strictly left of
  /// the line to p, and its start is not.
  Sighting straight(Index source, HalfEdge h) {
    for (;;) {
      step();
      if (mesh_.held(h)) return {Sighting::Kind::blocked, h};
      const HalfEdge g = t_.twin(h);
      const Index apex = t_.corner(g);
      if (apex == infinite) throw Abandon(Outcome::inconsistent_predicate, "a look leaves the domain");
      const Sign apex_side = mesh_.kernel().orient2d(mesh_.point(source), p_, mesh_.point(apex));
      h = apex_side == Sign::positive ? next(g) : prev(g);
      if (side(h) != Sign::negative) return classify(triangle_of(g));
    }
  }

  /// From a corner of a triangle, whose link there is `link`, where p is beyond the edge that follows it
  /// counter-clockwise: around the corner that way, or the other way where a held edge is in this one. Along
  /// a held edge that leads to p the look goes on from its far end.
  Sighting past_vertex(HalfEdge link) {
    for (;;) {
      HalfEdge h = link;
      while (!mesh_.held(next(h))) {
        step();
        h = mesh_.next_link(h);
        if (leads_to_p(h)) return onward(h);
      }
      const HalfEdge wall = next(h);
      if (side(wall) != Sign::zero) return other_way(link, wall);
      if (const auto end = on_ray(wall, t_.corner(h))) return *end;
      link = prev(h);
      step();
    }
  }
  Sighting other_way(HalfEdge link, HalfEdge wall) {
    HalfEdge h = link;
    while (!mesh_.held(prev(h))) {
      step();
      h = prev(t_.twin(prev(h)));
      if (leads_to_p(h)) return onward(h);
    }
    if (side(prev(h)) == Sign::zero)
      if (const auto end = on_ray(prev(h), t_.corner(h))) return *end;
    return {Sighting::Kind::blocked, wall};
  }
  /// Of p on the line of an edge of the pivot: whether it is on the edge, or its far end.
  std::optional<Sighting> on_ray(HalfEdge edge, Index pivot) const {
    const bool starts = t_.from(edge) == pivot;
    const Index far = starts ? t_.to(edge) : t_.from(edge);
    if (strictly_between(mesh_.point(pivot), p_, mesh_.point(far)))
      return Sighting{Sighting::Kind::on_edge, edge};
    if (p_ == mesh_.point(far)) return Sighting{Sighting::Kind::at_vertex, starts ? prev(edge) : next(edge)};
    return std::nullopt;
  }
  bool leads_to_p(HalfEdge link) const {
    const Index pivot = t_.corner(link);
    return turn(pivot, t_.to(link)) == Sign::negative && turn(pivot, t_.from(link)) != Sign::negative;
  }
  Sighting onward(HalfEdge link) {
    return side(link) == Sign::negative ? straight(t_.corner(link), link) : classify(triangle_of(link));
  }

  const Mesh& mesh_;
  const PlanarMesh& t_;
  Point2 p_;
  std::uint64_t& steps_;
  Budget budget_;
};

}  // namespace

Sighting look(const Mesh& mesh, Index t, Point2 p, std::uint64_t& steps) {
  return Look(mesh, p, steps).from(t);
}

}  // namespace tribunal::refinement
