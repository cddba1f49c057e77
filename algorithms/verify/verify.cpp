// The checks in order, and why a mesh that passes them is a Delaunay triangulation.
//
// Write S for the distinct sites, H for their convex hull. Suppose that
//
// (1) every triangle has three distinct sites as corners and positive orientation (triangles.cpp);
//
// (2) every edge has one triangle, or two on opposite sides of it (topology.cpp);
//
// (3) the edges that have one triangle, directed so that it is on their left, are exactly the edges of the
// boundary of H between consecutive sites, collinear ones included, counter-clockwise (boundary.cpp);
//
// (4) every site is a corner of some triangle (topology.cpp).
//
// Then the triangles are a triangulation of S: they cover H, and two of them meet in a common edge, a common
// corner or not at all.
//
// Covering once. Let p be a point on no line through two sites. For a positively oriented triangle the
// winding number of its boundary around p is 1 if p is inside it, else 0. Sum over all triangles: the sum
// counts the triangles that contain p; and the boundaries add up, by (2), where the two uses of an edge run
// in opposite directions and cancel, to the edges with one triangle, which by (3) are the boundary of H run
// through once. So p is in exactly one triangle if it is in H, and in none otherwise. Such points are dense:
// the triangles' interiors are disjoint, their union is H.
//
// Meeting properly. Let s be a site, by (4) a corner of a triangle t. Then s is not inside another triangle
// t', for t and t' would overlap near s. Nor is s inside an edge e of t': if e has one triangle, it is by (3)
// an edge of the boundary of H between consecutive sites and has no site inside; if it has two, they lie by
// (2) on opposite sides and together cover a neighbourhood of s, so t would overlap one of them. Now let two
// triangles share a point, their interiors being disjoint. They meet in a convex set without interior: a
// segment or a point. A segment lies in an edge of each, and as no corner is inside an edge, these edges are
// equal. A point inside an edge of each would be a crossing of edges, hence an overlap; so it is a corner of
// one, therefore not inside an edge of the other, therefore a corner of both. []
//
// If moreover (5) no edge has an apex strictly inside the circle of the triangle across it (delaunay.cpp),
// then no circle of a triangle has a site strictly inside: Delaunay's lemma (1934).
//
// The checks for doubled triangles, fans around vertices, pieces, Euler's count and crossings thus find
// nothing where (1) to (4) hold. They are there to name what is wrong where those do not, and stand guard
// over each other: doubles, fans, pieces and the count are always looked at. The sweep for crossings is not,
// and need not be. It looks at the triangles that have an area, each once and turned counter-clockwise; if
// none was flat and (2) and (3) hold, the argument above applies to these and their corners, so that nothing
// overlaps.
#include "algorithms/verify/verify.hpp"

#include "algorithms/verify/boundary.hpp"
#include "algorithms/verify/crossing.hpp"
#include "algorithms/verify/delaunay.hpp"
#include "algorithms/verify/fault_list.hpp"
#include "algorithms/verify/sites.hpp"
#include "algorithms/verify/topology.hpp"
#include "algorithms/verify/triangles.hpp"

#include <cmath>
#include <stdexcept>

namespace tribunal::verify {
namespace {

void require_domain(std::span<const Point2> points, const Mesh& mesh) {
  if (points.size() >= no_neighbour || mesh.triangles.size() >= no_neighbour)
    throw std::invalid_argument("verify: more points or triangles than 32 bits can number");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]))
      throw std::invalid_argument("verify: point " + std::to_string(i) + " is not finite");
}

bool may_overlap(const FaultList& faults) {
  return faults.has(FaultKind::flat_triangle) || faults.has(FaultKind::non_manifold_edge) ||
         faults.has(FaultKind::folded_edge) || faults.has(FaultKind::hull_mismatch) ||
         faults.has(FaultKind::not_connected);
}

}  // namespace

Verdict verify_planar(std::span<const Point2> points, const Mesh& mesh, const Options& options) {
  require_domain(points, mesh);
  FaultList faults(options.max_faults);
  Verdict verdict;
  const Sites sites = find_sites(points);
  verdict.dimension = sites.dimension;
  verdict.sites = verdict.hull = sites.sorted.size();

  const std::vector<SoundTriangle> triangles = check_triangles(points, sites, mesh, faults);
  // In dimension 0 and 1 there are no triangles but unsound and flat ones, which have just been named.
  if (sites.dimension == 2) {
    const std::vector<EdgeUse> uses = edge_uses(triangles);
    const std::vector<std::uint32_t> hull = convex_hull(points, sites);
    verdict.hull = hull.size();
    check_edges(triangles, uses, faults);
    check_boundary(points, hull, triangles, uses, faults);
    check_sites(sites, triangles, faults);
    check_vertices(points.size(), triangles, uses, faults);
    check_pieces(triangles, uses, faults);
    check_count(mesh.triangles.size(), verdict.sites, verdict.hull, faults);
    check_neighbours(mesh, triangles, uses, faults);
    if (may_overlap(faults)) find_crossing(points, sites, triangles, uses, faults);
    if (options.kind == Kind::delaunay) verdict.ties = check_circles(points, triangles, uses, faults);
  }
  verdict.found = faults.found();
  verdict.faults = faults.take();
  return verdict;
}

}  // namespace tribunal::verify
