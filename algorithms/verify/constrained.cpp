// Why a mesh that passes these checks is the constrained Delaunay triangulation of its points and segments.
//
// Triangles are sound and turn counter-clockwise; no edge has two on one side (topology.cpp); no two edges
// cross, and no site, in the mesh or not, lies inside an edge or a triangle (crossing.cpp, which always runs
// here). Then two triangles never overlap: the corners of what they had in common would be common corners,
// hence all three, and doubles are found. So the triangles are a triangulation of what they cover, with all
// the sites that lie there.
//
// What they cover is the domain. Where it is the convex hull, by the argument of verify.cpp. By the even-odd
// rule: the edges with one triangle are those under an odd number of segments, and no others; whether a point
// is covered then changes across the same edges as whether it is inside, and neither is true far away. Where
// it is carved: the edges with one triangle are pieces of segments, so each region between segments is
// covered wholly or not at all; not covered are the unbounded one and those that holes mark, and no others
// (faces.cpp).
//
// Every segment is a union of edges as far as it runs inside the domain (pieces.cpp), and every edge that is
// no piece of one is locally Delaunay (where that is asked for), which makes the triangulation constrained
// Delaunay (Lee and Lin 1986).
#include "algorithms/verify/boundary.hpp"
#include "algorithms/verify/crossing.hpp"
#include "algorithms/verify/delaunay.hpp"
#include "algorithms/verify/faces.hpp"
#include "algorithms/verify/fault_list.hpp"
#include "algorithms/verify/pieces.hpp"
#include "algorithms/verify/sites.hpp"
#include "algorithms/verify/topology.hpp"
#include "algorithms/verify/triangles.hpp"
#include "algorithms/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tribunal::verify {
namespace {

bool is_finite(Point2 p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }

void require_domain(std::span<const Point2> points, const Mesh& mesh, const Segments& segments) {
  if (points.size() >= no_neighbour || mesh.triangles.size() >= no_neighbour)
    throw std::invalid_argument("verify: more points or triangles than 32 bits can number");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw std::invalid_argument("verify: point " + std::to_string(i) + " is not finite");
  for (const auto& segment : segments.segments)
    for (const std::uint32_t end : segment)
      if (end >= points.size()) throw std::invalid_argument("verify: a segment ends at no point");
  for (const Point2& hole : segments.holes)
    if (!is_finite(hole)) throw std::invalid_argument("verify: a hole is not finite");
}

const Piece* find_piece(std::span<const Piece> pieces, std::uint32_t low, std::uint32_t high) {
  const auto found =
      std::lower_bound(pieces.begin(), pieces.end(), std::pair(low, high),
                       [](const Piece& p, const auto& ends) { return std::pair(p.low, p.high) < ends; });
  return found != pieces.end() && found->low == low && found->high == high ? &*found : nullptr;
}

/// The mesh ends only on segments; by the even-odd rule, exactly on those that count.
void check_ends(std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                std::span<const Piece> pieces, Domain domain, FaultList& faults) {
  const auto ends_domain = [&](const Piece& piece) {
    return domain == Domain::carved || piece.segments % 2 == 1;
  };
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 1) return;
    const Piece* piece = find_piece(pieces, edge[0].low, edge[0].high);
    if (piece == nullptr || !ends_domain(*piece))
      faults.add(FaultKind::wrong_domain, {triangles[edge[0].sound].index}, {edge[0].low, edge[0].high},
                 "the mesh ends where the domain does not");
  });
  if (domain != Domain::even_odd) return;
  for (const Piece& piece : pieces)
    if (piece.segments % 2 == 1 && piece.left_covered == piece.right_covered)
      faults.add(FaultKind::wrong_domain, {}, {piece.low, piece.high},
                 "the domain ends where the mesh does not");
}

std::vector<std::array<std::uint32_t, 2>> ends_of(std::span<const Piece> pieces) {
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const Piece& piece : pieces) ends.push_back({piece.low, piece.high});
  return ends;
}

}  // namespace

Verdict verify_constrained(std::span<const Point2> points, const Mesh& mesh, const Segments& segments,
                           const Options& options) {
  require_domain(points, mesh, segments);
  FaultList faults(options.max_faults);
  Verdict verdict;
  const Sites sites = find_sites(points);
  verdict.dimension = sites.dimension;
  verdict.sites = verdict.hull = sites.sorted.size();
  const std::vector<SoundTriangle> triangles = check_triangles(points, sites, mesh, faults);
  if (sites.dimension == 2) {
    const std::vector<EdgeUse> uses = edge_uses(triangles);
    const std::vector<std::uint32_t> hull = convex_hull(points, sites);
    verdict.hull = hull.size();
    check_edges(triangles, uses, faults);
    check_neighbours(mesh, triangles, uses, faults);
    find_crossing(points, sites, triangles, uses, faults, true);
    const std::vector<Piece> pieces = follow_segments(points, sites, triangles, uses, segments, faults);
    if (segments.domain == Domain::hull) {
      check_boundary(points, hull, triangles, uses, faults);
      check_sites(sites, triangles, faults);
      check_count(mesh.triangles.size(), verdict.sites, verdict.hull, faults);
    } else {
      check_ends(triangles, uses, pieces, segments.domain, faults);
    }
    if (segments.domain == Domain::carved) check_regions(points, pieces, segments.holes, faults);
    if (options.kind == Kind::delaunay)
      verdict.ties = check_circles(points, triangles, uses, faults, ends_of(pieces));
  }
  verdict.found = faults.found();
  verdict.faults = faults.take();
  return verdict;
}

}  // namespace tribunal::verify
