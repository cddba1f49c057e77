#include "algorithms/plugin/mesher_loader.hpp"

namespace tribunal {
namespace {

static_assert(sizeof(Point2) == 2 * sizeof(double) && sizeof(Edge) == 2 * sizeof(std::uint32_t),
              "points and segments are laid out as the interface says");

const double* coordinates(std::span<const Point2> points) {
  return points.empty() ? nullptr : points.front().coordinate.data();
}

tribunal_graph offered(const Graph& graph) {
  return {.points = coordinates(graph.points),
          .segments = graph.segments.empty() ? nullptr : graph.segments.front().data(),
          .holes = coordinates(graph.holes),
          .n = graph.points.size(),
          .m = graph.segments.size(),
          .h = graph.holes.size()};
}

PluginGraphMesh& mesh_of(void* sink) { return *static_cast<PluginGraphMesh*>(sink); }

tribunal_receiver receiver_of(PluginGraphMesh& mesh) {
  return {.sink = &mesh,
          .vertex =
              [](void* sink, double x, double y) {
                mesh_of(sink).vertices.push_back({{x, y}});
              },
          .triangle =
              [](void* sink, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                mesh_of(sink).triangles.push_back({a, b, c});
              },
          .subsegment =
              [](void* sink, std::uint32_t a, std::uint32_t b) {
                mesh_of(sink).subsegments.push_back({a, b});
              }};
}

}  // namespace

std::optional<MesherPlugin> MesherPlugin::load(const SharedLibrary& library) {
  const auto* offer = library.offer<tribunal_mesher>("tribunal_mesher_entry", TRIBUNAL_PLUGIN_VERSION);
  if (offer == nullptr) return std::nullopt;
  if (offer->triangulate == nullptr && offer->refine == nullptr)
    library.refuse("tribunal_mesher_entry offers neither triangulate nor refine");
  return MesherPlugin(*offer);
}

PluginGraphMesh MesherPlugin::triangulate(const Graph& graph) const {
  PluginGraphMesh mesh;
  mesh.triangles.reserve(2 * graph.points.size());
  const tribunal_graph given = offered(graph);
  const tribunal_receiver receiver = receiver_of(mesh);
  mesh.ending = offer_->triangulate(&given, &receiver);
  return mesh;
}

PluginGraphMesh MesherPlugin::refine(const Graph& graph, const tribunal_bounds& bounds) const {
  PluginGraphMesh mesh;
  const tribunal_graph given = offered(graph);
  const tribunal_receiver receiver = receiver_of(mesh);
  mesh.ending = offer_->refine(&given, &bounds, &receiver);
  return mesh;
}

}  // namespace tribunal
