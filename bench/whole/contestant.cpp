#include "bench/whole/contestant.hpp"

#include "algorithms/list.hpp"
#include "algorithms/plugin/loader.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/input.hpp"
#include "bench/measure.hpp"
#include "predicates/backends/list.hpp"

#include <memory>

namespace tribunal::bench {
namespace {

Lap run_method(const Method& method, std::uint64_t order_seed, std::span<const Point2> points) {
  const double start = thread_seconds();
  const auto order = insertion_order(points, method.order, order_seed);
  const Kernel2Binding bound = find_backend(method.backend)->bind2(points);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) return {Outcome::out_of_domain, describe(*refusal)};
  Triangulation result = triangulate(points, order, *std::get<0>(bound),
                                     *find_planar_algorithm(method.algorithm), method.settings);
  return {result.outcome, std::move(result.reason), std::move(result.triangles), thread_seconds() - start};
}

Lap run_plugin(const TriangulatorPlugin& plugin, std::span<const Point2> points) {
  const double start = thread_seconds();
  PluginMesh mesh = plugin.triangulate(points);
  const double seconds = thread_seconds() - start;
  if (mesh.ending == TRIBUNAL_DONE) return {Outcome::ok, {}, std::move(mesh.triangles), seconds};
  return {Outcome::refused_input, "it ends with code " + std::to_string(mesh.ending)};
}

}  // namespace

std::string describe(const Method& method) {
  std::string text = method.algorithm;
  for (const auto& [name, value] : method.settings) text.append(" ").append(name).append("=").append(value);
  text.append(", ").append(method.backend).append(", ");
  return text.append(order_names()[static_cast<std::size_t>(method.order)]).append(" order");
}

Contestant contestant_of(const Method& method, std::uint64_t order_seed) {
  return {describe(method), find_planar_algorithm(method.algorithm)->about.promise,
          [method, order_seed](std::span<const Point2> points) {
            return run_method(method, order_seed, points);
          }};
}

std::optional<Contestant> peer_contestant(const std::string& module_path) {
  const auto plugin = TriangulatorPlugin::load(SharedLibrary(module_path));
  if (!plugin) return std::nullopt;
  return Contestant{plugin->name(), Promise::delaunay, [plugin = *plugin](std::span<const Point2> points) {
                      return run_plugin(plugin, points);
                    }};
}

}  // namespace tribunal::bench
