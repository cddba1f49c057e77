// Point and mesh files: readers that refuse with file and line, writers whose numbers read back to the same
// bits.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// A file the user gave cannot be used: what() is one line "file:line: reason" (line omitted where there is
/// none, with
/// ":column" where it is known).
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct PointFile {
  std::vector<Point2> points;
  std::vector<std::uint64_t> lines;  ///< 1-based line of each point; for reporting duplicates
  std::vector<double> values;        ///< third column or attribute, empty when there is none
};

/// A mesh file: triangles as they stand in it, 0-based. Coordinates if the format carries them (.off), else
/// empty.
struct MeshFile {
  std::vector<Point2> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Reads .xy, .xyz, .csv, .node, .off by the file's ending; "-" is standard input as .xy. Throws BadInput:
/// unreadable path, no points, text where a number belongs, NaN or infinity, too few columns, ragged rows, a
/// header that announces more (without allocating what it announces) or fewer items than there are.
PointFile read_points(const std::filesystem::path& path);

/// Reads .ele (indices 0- or 1-based, told by the first triangle's line as Triangle does) or .off; "-" is
/// standard input as .off. Throws BadInput as above, and for a vertex that is not among the `sites` points of
/// the mesh (.ele does not know how many there are) or among those of the .off file itself.
MeshFile read_mesh(const std::filesystem::path& path, std::uint64_t sites = std::uint64_t{1} << 32);

/// Writes points in the format of the file's ending, "-" is standard output as .xy. Numbers are the shortest
/// decimals that read back to the same bits. Writes to a temporary name and renames, so that a failure leaves
/// nothing half-written. Throws BadInput.
void write_points(const std::filesystem::path& path, std::span<const Point2> points);

/// The ending of a path's name, with its dot, in lower case.
std::string ending_of(const std::filesystem::path& path);

/// The files that write_mesh(path) would write: the mesh, and for .ele the points beside it. Throws BadInput
/// where the ending is of no mesh format, so that a command can refuse before it computes.
std::vector<std::filesystem::path> mesh_files(const std::filesystem::path& path);

/// Writes a mesh: .off, or .ele with its .node beside it; "-" is standard output as .off. Else as
/// write_points.
void write_mesh(const std::filesystem::path& path, std::span<const Point2> points,
                std::span<const std::array<std::uint32_t, 3>> triangles);

struct FormatAbout {
  std::string_view name;     ///< ".xy"
  std::string_view holds;    ///< "points", "mesh" or "points, mesh"
  std::string_view summary;  ///< one line
};
/// What `tribunal list formats` prints.
std::span<const FormatAbout> formats();

}  // namespace tribunal
