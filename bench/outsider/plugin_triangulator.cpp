#include "bench/outsider/plugin_triangulator.hpp"

#include "algorithms/plugin/loader.hpp"
#include "bench/measure.hpp"
#include "bench/outsider/replay.hpp"
#include "predicates/environment.hpp"

namespace tribunal::bench {

OutsiderMesh PluginTriangulator::triangulate(std::span<const Point2> points) const {
  using End = OutsiderMesh::End;
  const SharedLibrary library(path_);
  const auto plugin = TriangulatorPlugin::load(library);
  if (!plugin) library.refuse("defines no tribunal_triangulator_entry");
  const double start = thread_seconds();
  PluginMesh mesh = plugin->triangulate(points);
  const double seconds = thread_seconds() - start;
  if (mesh.ending == TRIBUNAL_REFUSED) return {End::refused, "refused by the plug-in", {}, seconds};
  if (mesh.ending != TRIBUNAL_DONE)
    return {End::garbage, "gave up with code " + std::to_string(mesh.ending), {}, seconds};
  if (mesh.emitted > mesh.triangles.size())
    return {End::garbage, std::to_string(mesh.emitted) + " triangles, more than 2n", {}, seconds};
  if (const std::string fault = describe_fault(witness_floating_point()); !fault.empty())
    return {End::garbage, "it changes the floating-point environment: " + fault, {}, seconds};
  return {End::done, {}, std::move(mesh.triangles), seconds};
}

std::string PluginTriangulator::options() const { return "--plugin " + shell_word(path_); }

}  // namespace tribunal::bench
