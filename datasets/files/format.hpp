// What a file format is made of; one per file here, put in order by formats.cpp.
#pragma once

#include "datasets/files/files.hpp"
#include "datasets/files/pslg.hpp"
#include "datasets/files/scanner.hpp"

namespace tribunal::files {

using Triangle = std::array<std::uint32_t, 3>;

/// Functions between text and data; null where the format does not hold such things.
struct Format {
  FormatAbout about;
  Scanner::Separator separator = Scanner::Separator::blanks;
  PointFile (*read_points)(Scanner&) = nullptr;
  /// Vertex indices must be below `sites`.
  MeshFile (*read_mesh)(Scanner&, std::uint64_t sites) = nullptr;
  std::string (*write_points)(std::span<const Point2>) = nullptr;
  std::string (*write_mesh)(std::span<const Point2>, std::span<const Triangle>) = nullptr;
  /// `path` is that of the text, for files beside it.
  PslgFile (*read_pslg)(const std::filesystem::path& path, std::string_view text) = nullptr;
  /// The format of the file that holds the mesh's points and is written beside it; null when the mesh file
  /// holds them.
  const Format* points_beside = nullptr;
};

/// The text of a .poly file whose points are in a .node file beside it.
std::string poly_text(const PolyBoundary& boundary);

extern const Format xy;
extern const Format xyz;
extern const Format csv;
extern const Format node;
extern const Format ele;
extern const Format off;
extern const Format poly;
extern const Format geojson;
extern const Format wkt;

}  // namespace tribunal::files
