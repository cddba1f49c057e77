// What colours mean.
#pragma once

#include "datasets/pictures/drawing.hpp"
#include "datasets/pictures/surface.hpp"
#include "datasets/pictures/triangle_angles.hpp"

#include <string>
#include <vector>

namespace tribunal::pictures {

/// Bands of colour, and the numbers between them: one more than there are bands.
struct Scale {
  std::vector<std::string> borders;
};

Scale scale_of(const AngleScale& angles);
Scale scale_of(const Bands& bands);

/// As many areas without polygons, in the colours of as many bands.
std::vector<Areas> shades(std::size_t bands);

/// Adds the scale at the right of a drawing whose areas are those of shades().
void add_legend(Drawing& drawing, const Scale& scale);

}  // namespace tribunal::pictures
