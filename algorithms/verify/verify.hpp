// The exact checker: is this mesh what it claims to be? It shares no code with what it checks.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::verify {

enum class Kind : std::uint8_t { triangulation, delaunay };

/// What can be wrong with a mesh. Behind each: the triangles | the points that its Fault names. Edges are
/// named by their ends, smaller index first; duplicated points by their first copy, except in duplicate_used.
enum class FaultKind : std::uint8_t {
  index_out_of_range,   ///< a triangle names a point that is not there: it | the numbers that are no points
  repeated_corner,      ///< a triangle names one point twice: it | the point
  duplicate_used,       ///< a triangle uses a later copy of a duplicated point: it | the copy, the first
  wrong_orientation,    ///< a triangle is clockwise: it | its corners
  flat_triangle,        ///< a triangle has no area: it | its corners
  doubled_triangle,     ///< two triangles have the same corners: the first, the later | the corners
  non_manifold_edge,    ///< an edge has more than two triangles: they | the edge
  folded_edge,          ///< both triangles of an edge lie on the same side of it: they | the edge
  crossing_edges,       ///< two edges cross, a vertex lies inside an edge or a triangle: theirs | both edges'
                        ///< ends, the vertex and the edge, or the vertex and the corners
  non_manifold_vertex,  ///< the triangles around a vertex form more than one fan: one of each | the vertex
  missing_site,         ///< a point is in no triangle: none | the point
  hull_mismatch,  ///< the outer boundary is not the boundary of the convex hull: the triangle behind an edge
                  ///< of the boundary (none for an edge of the hull that is not there) | the edge
  not_connected,  ///< the triangles enclose a hole or slit: those around it | their corners on it; or they
                  ///< form more than one piece: one of each | none
  wrong_count,    ///< Euler: triangles != 2n - 2 - h: none | none
  wrong_neighbour,  ///< a given neighbour is not across the edge: the triangle, the neighbour if there is
                    ///< such a triangle | the edge
  non_delaunay,     ///< a vertex lies strictly inside the circle across an edge: both | the edge, both apexes
  missing_segment,  ///< a segment is no union of edges: none | its ends and where it breaks off
  wrong_domain,     ///< the mesh does not end where the domain does: the triangles there | the edge, or
                    ///< the corners of the region; or a hole is covered: none | the edge above it
};
inline constexpr std::size_t fault_kinds = 18;
inline constexpr std::size_t fault_kinds_of_point_meshes = 16;  ///< the last two need segments

/// The enumerator's name.
std::string_view to_string(FaultKind kind);

struct Fault {
  FaultKind kind;
  std::vector<std::uint32_t> simplices;  ///< the triangles concerned (or none, where no triangle is)
  std::vector<std::uint32_t> points;     ///< the points concerned
  std::string detail;                    ///< one line for people
};

struct Verdict {
  std::vector<Fault> faults;  ///< at most Options::max_faults; empty when the mesh is valid
  std::uint64_t found = 0;    ///< faults found, those that were not kept included
  int dimension = 2;          ///< of the point set, exactly: -1 (none), 0, 1 or 2
  std::uint64_t sites = 0;    ///< distinct points
  std::uint64_t hull = 0;     ///< distinct points on the boundary of the convex hull, collinear ones included
  std::uint64_t ties = 0;     ///< interior edges whose four points are cocircular (Delaunay kind)
  bool valid() const { return faults.empty(); }
};

inline constexpr std::uint32_t no_neighbour = 0xFFFFFFFF;

struct Mesh {
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise, 0-based
  /// Optional: across from corner i of each triangle; no_neighbour on the boundary. Empty: not given, not
  /// checked.
  std::span<const std::array<std::uint32_t, 3>> neighbours = {};
};

struct Options {
  Kind kind = Kind::delaunay;
  std::size_t max_faults = 100;  ///< 0 counts as 1; where there are more faults, every kind keeps its share
};

/// Which part of the plane a mesh with segments covers.
enum class Domain : std::uint8_t {
  hull,      ///< the convex hull of the points
  carved,    ///< what neither infinity nor a hole point reaches without crossing a segment
  even_odd,  ///< what is separated from infinity by an odd number of segments, overlapping ones counted each
};

struct Segments {
  std::span<const std::array<std::uint32_t, 2>> segments;  ///< by index into the points
  std::span<const Point2> holes = {};                      ///< for Domain::carved
  Domain domain = Domain::hull;
};

/// Checks that a mesh is the constrained Delaunay triangulation of points and segments: every segment is a
/// union of edges (but for what lies outside the domain), edges on no segment are locally Delaunay (not asked
/// of Kind::triangulation), and the triangles cover the domain once and nothing else. Exact, like
/// verify_planar, whose faults and exceptions are these; throws std::invalid_argument also for a segment that
/// names no point and a hole that is not finite. O(n log n), but for a look at everything for each hole, each
/// region left out and each stretch of a segment outside the mesh.
Verdict verify_constrained(std::span<const Point2> points, const Mesh& mesh, const Segments& segments,
                           const Options& options = {});

/// Checks a mesh over all of `points`. Exact: every sign by integers of unbounded size behind its own
/// certified floating-point filter. O(n log n). Locally Delaunay everywhere, on a valid triangulation of the
/// convex hull, is globally Delaunay (Delaunay's lemma). Points that all lie on one line are valid without
/// triangles.
///
/// Faults are sorted by kind, then by triangles. A clockwise triangle is named and then read the other way
/// round, a doubled one is left out, so that the checks that follow name only what else is wrong. Of crossing
/// edges one pair is named. Throws std::invalid_argument naming the first point that is not finite, or when
/// there are 2^32 - 1 points or triangles or more.
Verdict verify_planar(std::span<const Point2> points, const Mesh& mesh, const Options& options = {});

}  // namespace tribunal::verify
