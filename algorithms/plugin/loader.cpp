#include "algorithms/plugin/loader.hpp"

namespace tribunal {
namespace {

/// Where emit puts triangles. An outsider may emit without end: what is beyond any triangulation is counted
/// only.
struct Sink {
  PluginMesh mesh;
  std::size_t most;
};

void take_triangle(void* sink, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  auto& [mesh, most] = *static_cast<Sink*>(sink);
  ++mesh.emitted;
  if (mesh.triangles.size() < most) mesh.triangles.push_back({a, b, c});
}

}  // namespace

std::optional<TriangulatorPlugin> TriangulatorPlugin::load(const SharedLibrary& library) {
  const auto* offer =
      library.offer<tribunal_triangulator>("tribunal_triangulator_entry", TRIBUNAL_PLUGIN_VERSION);
  if (offer == nullptr) return std::nullopt;
  if (offer->triangulate == nullptr) library.refuse("tribunal_triangulator_entry offers no triangulate");
  return TriangulatorPlugin(*offer);
}

PluginMesh TriangulatorPlugin::triangulate(std::span<const Point2> points) const {
  static_assert(sizeof(Point2) == 2 * sizeof(double), "points are laid out as the interface says");
  Sink sink{{}, 2 * points.size()};
  sink.mesh.triangles.reserve(sink.most);
  const double* coordinates = points.empty() ? nullptr : points.front().coordinate.data();
  sink.mesh.ending = offer_->triangulate(coordinates, points.size(), take_triangle, &sink);
  return std::move(sink.mesh);
}

}  // namespace tribunal
