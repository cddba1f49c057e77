// Points that coincide.
#pragma once

#include "algorithms/triangulation.hpp"
#include "predicates/point.hpp"

#include <span>
#include <vector>

namespace tribunal {

/// For each index, the first index with an equal point; -0 equals +0. Expected O(n), by hashing.
std::vector<Index> first_occurrences(std::span<const Point2> points);

}  // namespace tribunal
