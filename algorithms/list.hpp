// The algorithms there are.
#pragma once

#include "algorithms/algorithm.hpp"

#include <span>
#include <string_view>

namespace tribunal {

/// All planar triangulation algorithms, in the order in which they are listed to users.
std::span<const PlanarAlgorithm> planar_algorithms();

/// The algorithm of that name, or null.
const PlanarAlgorithm* find_planar_algorithm(std::string_view name);

}  // namespace tribunal
