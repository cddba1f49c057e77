#include "algorithms/location/history_dag.hpp"

#include "algorithms/abandon.hpp"

namespace tribunal {

HistoryDag::HistoryDag(const PlanarProblem& problem, const PlanarMesh& mesh, Index root)
    : problem_(problem), mesh_(mesh), root_(root), origin_(mesh.triangle(root)) {
  children_.reserve(9 * problem.sites.size());
}

Triangle& HistoryDag::children_at(Index t) {
  if (t >= children_.size())
    children_.resize(mesh_.triangles(), {PlanarMesh::none, PlanarMesh::none, PlanarMesh::none});
  return children_[t];
}

HistoryDag::Place HistoryDag::locate(Index site) const {
  Place place{first_node(site), 1};
  for (; !alive(place.triangle); ++place.depth)
    place.triangle = child_holding(children_[place.triangle], place.triangle, site);
  return place;
}

Index HistoryDag::first_node(Index site) const {
  bool inside = true;
  for (HalfEdge h = 3 * root_; h < 3 * root_ + 3; ++h)
    inside = inside && side(mesh_.from(h), mesh_.to(h), site) != Sign::negative;
  if (inside) return root_;
  // Beyond the edge from u to v of the first triangle, the cone runs counter-clockwise from o -> u to o -> v.
  // The side of each ray is needed once: the cone is the one where it changes from left of u to right of v.
  for (Index i = 0; i < 3; ++i) {
    const HalfEdge h = 3 * root_ + i;
    const Index first_ghost = root_ + 1 + i;  // not twin(h): that one may be younger
    if (side_of_ray(mesh_.from(h), site) == Sign::positive &&
        side_of_ray(mesh_.to(h), site) == Sign::negative)
      return first_ghost;
  }
  throw Abandon(Outcome::inconsistent_predicate, "a site lies in no cone of the first triangle");
}

Index HistoryDag::child_holding(const Triangle& children, Index parent, Index site) const {
  if (children[2] == PlanarMesh::none) return child_of_cut(children, site);
  const HalfEdge hull_edge = mesh_.ghost_corner(parent);
  if (hull_edge != PlanarMesh::none) return child_of_ghost_star(children, hull_edge, site);
  return child_of_star(children, parent, site);
}

// The rays from the star's centre through the corners cut the parent in three. Each answer leaves one sector
// fewer, so that even contradictory signs end in some child.
Index HistoryDag::child_of_star(const Triangle& children, Index parent, Index site) const {
  const Triangle corner = mesh_.triangle(parent);
  const Index centre = mesh_.corner(3 * children[0]);
  if (side(centre, corner[0], site) != Sign::negative) {
    if (side(centre, corner[1], site) != Sign::positive) return children[2];
    return side(centre, corner[2], site) != Sign::positive ? children[0] : children[1];
  }
  if (side(centre, corner[2], site) != Sign::negative) return children[1];
  return side(centre, corner[1], site) != Sign::negative ? children[0] : children[2];
}

// A ghost (infinite, u, v) split by a centre outside the hull: the finite child (centre, u, v) and the ghosts
// beyond u -> centre, on the left of the ray through the centre, and centre -> v, on its right.
Index HistoryDag::child_of_ghost_star(const Triangle& children, HalfEdge hull_edge, Index site) const {
  const Index parent = triangle_of(hull_edge), centre = mesh_.corner(3 * children[0]);
  const HalfEdge at_u = next(hull_edge), at_v = prev(hull_edge);
  const Index finite = children[hull_edge - 3 * parent];
  if (side_of_ray(centre, site) == Sign::positive) {
    const bool beyond = side(mesh_.corner(at_u), centre, site) == Sign::positive;
    return beyond ? children[at_v - 3 * parent] : finite;
  }
  const bool beyond = side(centre, mesh_.corner(at_v), site) == Sign::positive;
  return beyond ? children[at_u - 3 * parent] : finite;
}

// On the line itself the finite child is right: a site on a hull edge belongs to the triangle inside it.
Index HistoryDag::child_of_cut(const Triangle& children, Index site) const {
  const Index centre = mesh_.corner(3 * children[0]), p = mesh_.corner(3 * children[0] + 1);
  const Sign where = p == infinite ? side_of_ray(centre, site) : side(centre, p, site);
  if (where == Sign::zero) return mesh_.is_ghost(children[0]) ? children[1] : children[0];
  return where == Sign::positive ? children[0] : children[1];
}

Sign HistoryDag::side(Index a, Index b, Index site) const {
  const auto& p = problem_.points;
  return problem_.kernel.orient2d(p[a], p[b], p[site]);
}

Sign HistoryDag::side_of_ray(Index through, Index site) const {
  for (const Index origin : origin_)
    if (const Sign s = side(origin, through, site); s != Sign::zero) return s;
  throw Abandon(Outcome::inconsistent_predicate,
                "two sites are collinear with all corners of the first triangle");
}

}  // namespace tribunal
