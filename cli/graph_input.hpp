// A file with segments on its way to an algorithm: what to do with crossings, which domain, and whose fault
// it is.
#pragma once

#include "algorithms/constrained/constrained.hpp"
#include "algorithms/parameter.hpp"
#include "datasets/files/pslg.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tribunal::cli {

struct GraphInput {
  std::string path;
  PslgFile file;              ///< after splitting: with crossing points and pieces
  std::vector<Index> origin;  ///< of each segment, its number in the file as it was read
  Domain domain;
  std::uint64_t rounded = 0, snapped = 0;  ///< as SplitGraph counts them

  Graph graph() const { return {file.sites.points, file.segments, file.holes, domain}; }
  /// "map.poly:12": where a segment stands.
  std::string place(Index segment) const;
};

/// hull, carved, even-odd or auto, which is what the file's segments mean, hull where there are none; throws
/// BadUsage.
Domain domain_named(const std::string& name, const PslgFile& file);
std::string_view to_string(Domain domain);

/// What the settings of `constrained` make of a file. Throws BadInput where crossings cannot be split.
GraphInput graph_input(std::string path, PslgFile file, const Settings& settings);

/// Why a graph was refused: "map.poly:12: crosses the segment of line 17".
std::string describe(const GraphInput& input, const ConstrainedTriangulation& refused);

/// What `triangulate --stats` says of segments.
nlohmann::json segments_json(const GraphInput& input, const ConstrainedTriangulation& found);

}  // namespace tribunal::cli
