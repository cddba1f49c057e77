// The shorelines of GSHHG as the Generic Mapping Tools store them: cut at the borders of bins.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tribunal::shores {

/// What a file binned_GSHHS_*.nc holds of the shores (Wessel and Smith 1996). The world is a grid of square
/// bins, row by row from the north, each from 0 degrees eastwards; a bin's shores are polylines of its own,
/// cut where they leave it.
struct BinnedShores {
  /// A polyline within a bin; land is to the left.
  struct Piece {
    std::uint32_t code;  ///< 512 points + 64 level + 8 side of entry + side of exit
    std::int32_t first_point;
    std::int32_t polygon;  ///< larger polygons have smaller numbers

    std::uint32_t size() const { return code >> 9; }
    std::uint32_t level() const { return code >> 6 & 7; }  ///< 1: between sea and land
    std::uint32_t entry() const { return code >> 3 & 7; }  ///< south, east, north, west; 4: closed in the bin
    std::uint32_t exit() const { return code & 7; }
  };
  struct Bin {
    std::int32_t first_piece;
    std::int32_t pieces;
  };

  std::int32_t bin_degrees = 0;
  std::vector<Bin> bins;
  std::vector<Piece> pieces;
  std::vector<std::uint16_t> east, north;  ///< by point, from the bin's south-west corner, in bins / 65535
};

/// Whether the program was built with the library that reads such files.
bool reads_binned_shores();

/// The file at `path`. Throws BadInput, with the path, where it is none, or truncated, or contradicts itself,
/// or where the program was built without libnetcdf. Of a damaged file libhdf5 may make worse than that.
BinnedShores read_binned_shores(const std::filesystem::path& path);

/// What is wrong with them, in a few words, "" if nothing: every bin has its pieces, every piece its points,
/// and the bins cover the world.
std::string contradiction(const BinnedShores& shores);

}  // namespace tribunal::shores
