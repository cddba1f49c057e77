// A figure as a Vega-Lite specification: data that a browser turns into an interactive chart.
#pragma once

#include "reports/figures/figure.hpp"

#include <nlohmann/json_fwd.hpp>

namespace tribunal::reports {

/// Self-contained (its data inline, no address anywhere) and without colours, which the page's theme sets.
nlohmann::json vega_lite(const Figure& figure);

}  // namespace tribunal::reports
