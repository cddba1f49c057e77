#include "algorithms/refinement/small_angles.hpp"

#include "algorithms/direction.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::refinement {
namespace {

/// The power of two between a third and two thirds of a length.
double circle_within(double length) { return std::ldexp(1, std::ilogb(length * (2.0 / 3))); }

/// The wedge at `apex` from the direction of `from` counter-clockwise to that of `to`.
struct Wedge {
  double cross, dot, legs;  // legs: the product of the squared lengths
};
Wedge wedge(Point2 apex, Point2 from, Point2 to) {
  const auto [ux, uy] = direction(apex, from);
  const auto [vx, vy] = direction(apex, to);
  return {ux * vy - uy * vx, ux * vx + uy * vy, (ux * ux + uy * uy) * (vx * vx + vy * vy)};
}
bool below_60_degrees(const Wedge& w) { return w.dot > 0 && w.cross > 0 && 4 * w.dot * w.dot > w.legs; }
bool below(const Wedge& w, AngleBound bound) {
  return w.dot > 0 && w.cross > 0 && w.cross * w.cross < bound.sine_squared * w.legs;
}

/// The ends of held edges around a vertex, counter-clockwise; the flag says whether all is domain from there
/// to the next one.
struct Spoke {
  Index end;
  bool domain_follows;
};
std::vector<Spoke> held_spokes(const SteinerMesh& mesh, Index vertex) {
  const PlanarMesh& t = mesh.triangles();
  std::vector<Spoke> spokes;
  const HalfEdge first = mesh.mesh().link(vertex);
  HalfEdge h = first;
  do {
    // prev(h) runs from the vertex to the start of its link's edge.
    if (mesh.mesh().held(prev(h))) spokes.push_back({t.from(h), mesh.in_domain(triangle_of(h))});
    h = mesh.mesh().next_link(h);
  } while (h != first);
  return spokes;
}

}  // namespace

SmallAngles::SmallAngles(const SteinerMesh& mesh, AngleBound bound)
    : apex_(mesh.mesh().vertices(), 0), circles_(mesh.mesh().vertices(), Circle{no_apex, 0}) {
  for (Index v = 0; v < apex_.size(); ++v) {
    const std::vector<Spoke> spokes = held_spokes(mesh, v);
    for (std::size_t i = 0; i < spokes.size() && spokes.size() > 1; ++i) {
      if (!spokes[i].domain_follows) continue;
      const Wedge w =
          wedge(mesh.point(v), mesh.point(spokes[i].end), mesh.point(spokes[(i + 1) % spokes.size()].end));
      apex_[v] |= below_60_degrees(w);
      below_bound_ += below(w, bound);
    }
  }
}

double SmallAngles::place_to_split(const SteinerMesh& mesh, HalfEdge h) const {
  const auto [from, to] = mesh.stretch(h);
  const double middle = from + (to - from) / 2;
  const Index a = mesh.triangles().from(h), b = mesh.triangles().to(h);
  if (is_apex(a) == is_apex(b)) return middle;
  const Edge ends = mesh.piece_ends(h);
  const double whole = distance(mesh.point(ends[0]), mesh.point(ends[1]));
  const double length = distance(mesh.point(a), mesh.point(b));
  const double radius = circle_within(length);
  const double step = std::copysign(radius / whole, is_apex(a) ? to - from : from - to);
  const double place = (is_apex(a) ? from : to) + step;
  return std::min(from, to) < place && place < std::max(from, to) ? place : middle;
}

void SmallAngles::note_split(const SteinerMesh& mesh, Edge ends, Index vertex) {
  circles_.resize(std::max<std::size_t>(circles_.size(), vertex + std::size_t{1}), Circle{no_apex, 0});
  const auto [a, b] = ends;
  if (is_apex(a) != is_apex(b)) {
    const Index apex = is_apex(a) ? a : b;
    const double length = distance(mesh.point(a), mesh.point(b));
    circles_[vertex] = {apex, circle_within(length)};
  } else if (circle(a).apex != no_apex && circle(a).apex == circle(b).apex) {
    circles_[vertex] = {circle(a).apex, circle(a).radius / 2 + circle(b).radius / 2};
  }
}

bool SmallAngles::forces(const SteinerMesh& mesh, Index t) const {
  const Triangle v = mesh.triangles().triangle(t);
  const auto edges = edge_lengths(mesh.corners(t));
  const auto i = static_cast<std::size_t>(std::min_element(edges.begin(), edges.end()) - edges.begin());
  const Index p = v[(i + 1) % 3], q = v[(i + 2) % 3], top = v[i];
  const Circle at_p = circle(p), at_q = circle(q);
  if (at_p.apex != no_apex && at_p.apex == at_q.apex && at_p.radius == at_q.radius) return true;
  const HalfEdge opposite = 3 * t + static_cast<Index>(i);
  return is_apex(top) && mesh.mesh().held(next(opposite)) && mesh.mesh().held(prev(opposite)) &&
         mesh.mesh().kernel().compare_length(mesh.point(top), mesh.point(p), mesh.point(top),
                                             mesh.point(q)) == Sign::zero;
}

}  // namespace tribunal::refinement
