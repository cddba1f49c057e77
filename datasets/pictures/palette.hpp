// Colours in an order that everybody sees.
#pragma once

#include "datasets/pictures/drawing.hpp"

namespace tribunal::pictures {

/// The colour of a number in [0, 1]: from pale yellow over red to a dark purple. Lightness, as eyes perceive
/// it, falls linearly, so that the order shows in print without colours, too.
Colour shade(double where);

}  // namespace tribunal::pictures
