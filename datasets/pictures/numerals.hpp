// Numbers drawn by strokes, so that a picture needs no font and looks the same everywhere.
#pragma once

#include "datasets/pictures/drawing.hpp"

#include <string_view>

namespace tribunal::pictures {

/// Digits, '.', '-', '+' and 'e', `height` units high, beginning at the lower left corner given.
std::vector<Stroke> numeral(std::string_view text, Position lower_left, double height);

}  // namespace tribunal::pictures
