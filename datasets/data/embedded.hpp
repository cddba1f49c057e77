// The data files of this folder, as they stand in the program.
#pragma once

#include <string_view>

namespace tribunal::data {

/// counties.txt: "arcs", then each arc as a point and steps from point to point; "rings", then each ring as
/// numbers of arcs, ~k for arc k backwards.
std::string_view counties();

/// coast.txt: "origin" on the lattice of counties.txt, "points", "segments".
std::string_view coast();

}  // namespace tribunal::data
