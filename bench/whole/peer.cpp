// Other people's libraries as contestants.
#include "algorithms/plugin/loader.hpp"
#include "algorithms/plugin/mesher_loader.hpp"
#include "bench/measure.hpp"
#include "bench/outsider/printable.hpp"
#include "bench/whole/contestant.hpp"
#include "predicates/environment.hpp"

#include <utility>

namespace tribunal::bench {
namespace {

/// Runs the plug-in by the clock; what it says becomes a lap, its triangles unchecked.
template <class Ask>
Lap clocked(const Ask& ask) {
  const double start = thread_seconds();
  auto mesh = ask();
  const double seconds = thread_seconds() - start;
  if (mesh.ending != TRIBUNAL_DONE)
    return {Outcome::refused_input, "it ends with code " + std::to_string(mesh.ending)};
  if (const std::string fault = describe_fault(witness_floating_point()); !fault.empty())
    return {Outcome::crash, "it changes the floating-point environment: " + fault};
  Lap lap{.triangles = std::move(mesh.triangles), .seconds = seconds};
  if constexpr (requires { mesh.vertices; }) {
    lap.vertices = std::move(mesh.vertices);
    lap.subsegments = std::move(mesh.subsegments);
  }
  return lap;
}

Graph graph_of(const Ground& ground) { return {ground.points, ground.segments, ground.holes}; }

Contestant triangulator(const TriangulatorPlugin& plugin) {
  return {printable(plugin.name()), Promise::delaunay, [plugin](const Ground& ground) {
            return clocked([&] { return plugin.triangulate(ground.points); });
          }};
}

Contestant graph_triangulator(const MesherPlugin& plugin) {
  return {printable(plugin.name()), Promise::delaunay, [plugin](const Ground& ground) {
            return clocked([&] { return plugin.triangulate(graph_of(ground)); });
          }};
}

Contestant refiner(const MesherPlugin& plugin) {
  return {printable(plugin.name()), Promise::delaunay, [plugin](const Ground& ground) {
            const tribunal_bounds bounds{ground.bounds.sine_squared, ground.bounds.longest_edge};
            return clocked([&] { return plugin.refine(graph_of(ground), bounds); });
          }};
}

}  // namespace

std::optional<Contestant> peer_contestant(const std::string& module_path, RaceKind kind) {
  const SharedLibrary library(module_path);
  if (kind == RaceKind::triangulation) {
    const auto plugin = TriangulatorPlugin::load(library);
    return plugin ? std::optional(triangulator(*plugin)) : std::nullopt;
  }
  const auto plugin = MesherPlugin::load(library);
  if (!plugin) return std::nullopt;
  if (kind == RaceKind::graph)
    return plugin->triangulates() ? std::optional(graph_triangulator(*plugin)) : std::nullopt;
  return plugin->refines() ? std::optional(refiner(*plugin)) : std::nullopt;
}

}  // namespace tribunal::bench
