#include "tests/faults/cgal_oracle.hpp"

#include "tests/faults/mesh_map.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace tribunal::faults {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

Kernel::Point_2 convert(Point2 p) { return {p[0], p[1]}; }

}  // namespace

CgalMesh cgal_delaunay(const std::vector<Point2>& points) {
  std::map<Point2, std::uint32_t> first;
  for (std::uint32_t i = 0; i < points.size(); ++i) first.emplace(points[i], i);
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> sites;
  for (const auto& [position, index] : first) sites.emplace_back(convert(position), index);
  const Delaunay delaunay(sites.begin(), sites.end());
  CgalMesh mesh{{}, delaunay.is_valid()};
  for (const auto face : delaunay.finite_face_handles())
    mesh.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return mesh;
}

CgalEdges cgal_judges_edges(const std::vector<Point2>& points, const std::vector<Triangle>& triangles) {
  const MeshMap map(triangles);
  CgalEdges edges;
  for (const Side& side : map.interior()) {
    if (side.from > side.to) continue;
    const CGAL::Oriented_side where =
        CGAL::side_of_oriented_circle(convert(points[side.from]), convert(points[side.to]),
                                      convert(points[side.apex]), convert(points[map.across(side)->apex]));
    edges.non_delaunay += where == CGAL::ON_POSITIVE_SIDE;
    edges.ties += where == CGAL::ON_ORIENTED_BOUNDARY;
  }
  return edges;
}

}  // namespace tribunal::faults
