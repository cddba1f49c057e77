// CGAL's constrained Delaunay triangulation and its Delaunay refinement (Ruppert's and Shewchuk's algorithm),
// over exact predicates and rounded constructions. Both are under the GPL, and so is this module once it is
// built.
#include "algorithms/plugin/tribunal_mesher.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/version.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

/// Vertices that were never given a number are new.
struct Number {
  std::uint32_t value = UINT32_MAX;
};

using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
template <class Face>
using Constrained =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Graph = Constrained<CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Mesh = Constrained<CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Mesh>;

std::vector<Point> points_of(const double* coordinates, std::size_t n) {
  std::vector<Point> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(coordinates[2 * i], coordinates[2 * i + 1]);
  return points;
}

/// What CGAL's own insert_constraints does with ranges of points and of pairs of indices; that one does not
/// tell which vertex became of which point.
template <class Triangulation>
void insert(const tribunal_graph& graph, Triangulation& triangulation) {
  const std::vector<Point> points = points_of(graph.points, graph.n);
  std::vector<std::size_t> order(graph.n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  using Places = CGAL::Pointer_property_map<Point>::const_type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Places>(CGAL::make_property_map(points)));
  std::vector<typename Triangulation::Vertex_handle> vertices(graph.n);
  typename Triangulation::Face_handle hint;
  for (const std::size_t i : order) {
    vertices[i] = triangulation.insert(points[i], hint);
    vertices[i]->info().value = static_cast<std::uint32_t>(i);
    hint = vertices[i]->face();
  }
  for (std::size_t s = 0; s < graph.m; ++s) {
    const auto a = vertices[graph.segments[2 * s]], b = vertices[graph.segments[2 * s + 1]];
    if (a != b) triangulation.insert_constraint(a, b);
  }
}

template <class FaceHandle>
void give(const FaceHandle& face, const tribunal_receiver& receiver) {
  receiver.triangle(receiver.sink, face->vertex(0)->info().value, face->vertex(1)->info().value,
                    face->vertex(2)->info().value);
}

/// Exceptions must not leave through C.
int triangulate(const tribunal_graph* graph, const tribunal_receiver* receiver) noexcept try {
  Graph triangulation;
  insert(*graph, triangulation);
  for (const auto face : triangulation.finite_face_handles()) give(face, *receiver);
  return TRIBUNAL_DONE;
} catch (...) {
  return TRIBUNAL_FAILED;
}

void give(const Mesh& mesh, std::size_t n, const tribunal_receiver& receiver) {
  auto next = static_cast<std::uint32_t>(n);
  for (const auto vertex : mesh.finite_vertex_handles()) {
    if (vertex->info().value != UINT32_MAX) continue;
    vertex->info().value = next++;
    receiver.vertex(receiver.sink, vertex->point().x(), vertex->point().y());
  }
  for (const auto face : mesh.finite_face_handles())
    if (face->is_in_domain()) give(face, receiver);
  for (const auto& [face, side] : mesh.finite_edges())
    if (face->is_constrained(side))
      receiver.subsegment(receiver.sink, face->vertex(Mesh::cw(side))->info().value,
                          face->vertex(Mesh::ccw(side))->info().value);
}

/// CGAL's bound is the squared sine, too, and its size the longest edge, where 0 means any.
int refine(const tribunal_graph* graph, const tribunal_bounds* bounds,
           const tribunal_receiver* receiver) noexcept try {
  Mesh mesh;
  insert(*graph, mesh);
  const std::vector<Point> holes = points_of(graph->holes, graph->h);
  CGAL::Delaunay_mesher_2<Mesh, Criteria> mesher(
      mesh, Criteria(bounds->sine_squared, std::isinf(bounds->longest_edge) ? 0 : bounds->longest_edge));
  mesher.set_seeds(holes.begin(), holes.end());
  mesher.refine_mesh();
  give(mesh, graph->n, *receiver);
  return TRIBUNAL_DONE;
} catch (...) {
  return TRIBUNAL_FAILED;
}

constexpr tribunal_mesher offer{TRIBUNAL_PLUGIN_VERSION,
                                "cgal-mesher",
                                "CGAL " CGAL_VERSION_STR,
                                "Constrained_Delaunay_triangulation_2 and Delaunay_mesher_2",
                                triangulate,
                                refine};

}  // namespace

extern "C" __attribute__((visibility("default"))) const tribunal_mesher* tribunal_mesher_entry() {
  return &offer;
}
