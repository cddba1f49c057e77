// A campaign's progress on standard error.
#pragma once

#include "bench/campaign.hpp"
#include "cli/console.hpp"

#include <functional>

namespace tribunal::cli {

/// What to call after each cell: `automatic` redraws one line on a terminal and is `plain` elsewhere; `plain`
/// prints a line every twentieth of the way; `json` prints one object per cell; `none` prints nothing.
std::function<void(const bench::Progress&)> progress_printer(Console& console);

}  // namespace tribunal::cli
