// The list of numbered points that .node files are and .poly files begin with.
#pragma once

#include "datasets/files/announced.hpp"
#include "datasets/files/files.hpp"

namespace tribunal::files {

/// A header (points, dimension, attributes, markers) and as many lines of number, x, y, attributes, marker.
struct NodeList {
  Announced announced;
  PointFile file;
  std::uint64_t base = 0;  ///< the number of the first point, 0 or 1; 0 where there is none
};

/// Reads the list from the current line of the scanner on, up to its last point. A list without points is
/// refused unless it `may_be_empty`.
NodeList read_node_list(Scanner& scanner, bool may_be_empty = false);

}  // namespace tribunal::files
