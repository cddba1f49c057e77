// CGAL's kernel of exact predicates and inexact constructions, and its Delaunay triangulation of the plane.
// The triangulation is under the GPL, and so is this module once it is built.
#include "algorithms/peers/cgal_predicates.hpp"
#include "algorithms/plugin/tribunal_triangulator.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/version.h>

#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

/// Exceptions must not leave through C.
int triangulate(const double* points, std::size_t n, tribunal_emit emit, void* sink) noexcept try {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> sites;
  sites.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
    sites.emplace_back(Kernel::Point_2(points[2 * i], points[2 * i + 1]), static_cast<std::uint32_t>(i));
  const Delaunay delaunay(sites.begin(), sites.end());
  for (const auto face : delaunay.finite_face_handles())
    emit(sink, face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
  return TRIBUNAL_DONE;
} catch (...) {
  return TRIBUNAL_FAILED;
}

constexpr tribunal_predicates predicates_offer = tribunal_peers::CgalPredicates<Kernel>::offer(
    "cgal-epick", "CGAL " CGAL_VERSION_STR,
    "interval filter, then exact arithmetic; Delaunay_triangulation_2");
constexpr tribunal_triangulator triangulator_offer{
    TRIBUNAL_PLUGIN_VERSION, "cgal-delaunay", "CGAL " CGAL_VERSION_STR,
    "Delaunay_triangulation_2 over exact predicates", triangulate};

}  // namespace

extern "C" __attribute__((visibility("default"))) const tribunal_predicates* tribunal_predicates_entry() {
  return &predicates_offer;
}

extern "C" __attribute__((visibility("default"))) const tribunal_triangulator* tribunal_triangulator_entry() {
  return &triangulator_offer;
}
