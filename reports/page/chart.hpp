// A figure as it stands on the page.
#pragma once

#include "reports/figures/figure.hpp"

#include <string>

namespace tribunal::reports {

/// Static chart with caption and legend, and beside it the specification from which the page's script draws
/// the interactive one in its place.
std::string chart(const Figure& figure);

}  // namespace tribunal::reports
