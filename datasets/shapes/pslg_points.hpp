// Domains whose sites are their boundary's.
#pragma once

#include "datasets/dataset.hpp"

#include <vector>

namespace tribunal::shapes {

/// The first n points of a domain that has at least n.
inline std::vector<Point2> first_points(DatasetGraph graph, std::uint64_t n) {
  graph.points.resize(n);
  return std::move(graph.points);
}

}  // namespace tribunal::shapes
