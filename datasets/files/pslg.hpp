// Planar straight-line graphs: points, segments between them, holes.
#pragma once

#include "datasets/files/files.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tribunal {

/// A planar straight-line graph as it stands in a file: points may coincide, segments may overlap, touch and
/// cross.
struct PslgFile {
  static constexpr std::uint32_t no_ring = 0xFFFFFFFF;
  PointFile sites;
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< by index into the sites; no two ends coincide
  std::vector<std::uint64_t> segment_lines;            ///< 1-based line of each segment
  std::vector<std::uint32_t> segment_rings;  ///< the ring of a polygon that each is part of, or no_ring
  std::vector<std::uint32_t> ring_outers;    ///< of each ring its polygon's outer one, which is a ring, too
  std::vector<Point2> holes;                 ///< a point inside each hole
  std::vector<std::uint64_t> hole_lines;
  /// What the segments mean to enclose: "even-odd" where they are the rings of polygons, "carved" in a .poly,
  /// unless it says otherwise in a first line "# domain NAME", else "hull".
  std::string domain = "hull";
};

/// The graph of a .poly (Triangle), .geojson or .wkt file; nothing where the path has another ending. Throws
/// BadInput as read_points does, and for a segment without length, a ring that does not close, a ring of less
/// than three points.
std::optional<PslgFile> read_pslg(const std::filesystem::path& path);

/// What a .poly file holds of a graph beside its points.
struct PolyBoundary {
  std::span<const std::array<std::uint32_t, 2>> segments;
  std::span<const Point2> holes;
  std::string_view domain;  ///< one that is not "carved" stands in the first line
};

/// A .poly file, and beside it the .node file with its points, numbered from 0. Both are complete before the
/// first replaces its predecessor.
void write_poly(const std::filesystem::path& path, std::span<const Point2> points,
                const PolyBoundary& boundary);

/// The .poly that goes beside a mesh.
std::filesystem::path poly_beside(const std::filesystem::path& mesh);

/// A mesh as `write_mesh` writes it; where its points are a file beside it, a .poly with the boundary, too,
/// and all are complete before the first replaces its predecessor.
void write_bounded_mesh(const std::filesystem::path& path, std::span<const Point2> points,
                        std::span<const std::array<std::uint32_t, 3>> triangles,
                        const PolyBoundary& boundary);

}  // namespace tribunal
