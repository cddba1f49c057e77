// A figure as static SVG: what a reader without JavaScript, or on paper, sees.
#pragma once

#include "reports/figures/figure.hpp"

#include <cstddef>
#include <string>

namespace tribunal::reports {

/// The chart without its title; colours come from the page's style sheet (classes series-0 ... series-7),
/// shapes and dashes tell the series apart without colour. Data that an axis cannot show (not finite; not
/// positive on a logarithmic one) are left out.
std::string svg(const Figure& figure);

/// A sample of the series' line or point for a legend. `index` counts the figure's series from 0.
std::string svg_swatch(Mark mark, std::size_t index);

}  // namespace tribunal::reports
