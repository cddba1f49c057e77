// Where a verb writes, checked before anything is computed: what is lost there was lost for nothing.
#pragma once

#include "cli/console.hpp"

#include <string>
#include <vector>

namespace tribunal::cli {

/// Paths; empty where there is none, "-" for standard output.
struct Outputs {
  std::vector<std::string> inputs;  ///< what the verb reads
  std::string mesh;
  bool boundary = false;  ///< whether a .poly goes beside a mesh of two files
  std::string stats;
  std::string picture;
};

/// Throws BadUsage where an output is an input or a file that an input leads to, where two outputs are one
/// file or both standard output, and where a file cannot be made for want of a folder.
void check_outputs(const Outputs& outputs, const Console& console);

}  // namespace tribunal::cli
