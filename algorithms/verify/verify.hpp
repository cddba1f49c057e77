// The exact checker: is this mesh what it claims to be? It shares no code with what it checks.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::verify {

enum class Kind : std::uint8_t { triangulation, delaunay };

enum class FaultKind : std::uint8_t {
  index_out_of_range,      ///< a triangle names a point that is not there
  repeated_corner,         ///< a triangle names one point twice
  duplicate_used,          ///< a triangle uses a later copy of a duplicated point
  wrong_orientation,       ///< a triangle is clockwise
  flat_triangle,           ///< a triangle has no area
  doubled_triangle,        ///< two triangles have the same corners
  non_manifold_edge,       ///< an edge has more than two triangles
  folded_edge,             ///< both triangles of an edge lie on the same side of it
  crossing_edges,          ///< two edges cross, or a vertex lies inside an edge
  non_manifold_vertex,     ///< the triangles around a vertex form more than one fan
  missing_site,            ///< a point is in no triangle
  hull_mismatch,           ///< the outer boundary is not the boundary of the convex hull
  not_connected,           ///< the triangles form more than one piece, or enclose a hole
  wrong_count,             ///< Euler: triangles != 2n - 2 - h
  wrong_neighbour,         ///< a given neighbour is not across the edge
  non_delaunay,            ///< a vertex lies strictly inside the circle across an edge
};
std::string_view to_string(FaultKind kind);

struct Fault {
  FaultKind kind;
  std::vector<std::uint32_t> simplices;  ///< the triangles concerned (or none, where no triangle is)
  std::vector<std::uint32_t> points;     ///< the points concerned
  std::string detail;                    ///< one line for people
};

struct Verdict {
  std::vector<Fault> faults;  ///< at most Options::max_faults; empty when the mesh is valid
  int dimension = 2;          ///< of the point set, exactly: -1 (none), 0, 1 or 2
  std::uint64_t sites = 0;    ///< distinct points
  std::uint64_t hull = 0;     ///< distinct points on the boundary of the convex hull, collinear ones included
  std::uint64_t ties = 0;     ///< interior edges whose four points are cocircular (Delaunay kind)
  bool valid() const { return faults.empty(); }
};

inline constexpr std::uint32_t no_neighbour = 0xFFFFFFFF;

struct Mesh {
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise, 0-based
  /// Optional: across from corner i of each triangle; no_neighbour on the boundary. Empty: not given, not checked.
  std::span<const std::array<std::uint32_t, 3>> neighbours = {};
};

struct Options {
  Kind kind = Kind::delaunay;
  std::size_t max_faults = 100;
};

/// Checks a mesh over all of `points` (finite). Exact: every sign by integers of unbounded size behind its own certified
/// floating-point filter. O(n log n). Locally Delaunay everywhere, on a valid triangulation of the convex hull, is
/// globally Delaunay (Delaunay's lemma). Points that all lie on one line are valid without triangles.
Verdict verify_planar(std::span<const Point2> points, const Mesh& mesh, const Options& options = {});

}  // namespace tribunal::verify
