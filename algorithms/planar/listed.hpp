// The entry of each listed algorithm; its file says what it does and how.
#pragma once

#include "algorithms/algorithm.hpp"

namespace tribunal {

#define ALGORITHM(name) extern const PlanarAlgorithm name##_algorithm;
#include "algorithms/planar/list.def"
#undef ALGORITHM

}  // namespace tribunal
