// CGAL as an outside opinion, behind a few functions, so that one unit compiles it.
#pragma once

#include "predicates/point.hpp"
#include "tests/faults/samples.hpp"

#include <cstdint>
#include <vector>

namespace tribunal::faults {

/// CGAL's Delaunay triangulation, vertices by the first index of their position; checked by CGAL's own
/// is_valid.
struct CgalMesh {
  std::vector<Triangle> triangles;
  bool valid;
};
CgalMesh cgal_delaunay(const std::vector<Point2>& points);

/// What CGAL's side_of_oriented_circle says of the interior edges of a valid triangulation.
struct CgalEdges {
  std::uint64_t non_delaunay = 0;
  std::uint64_t ties = 0;
};
CgalEdges cgal_judges_edges(const std::vector<Point2>& points, const std::vector<Triangle>& triangles);

}  // namespace tribunal::faults
