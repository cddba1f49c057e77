// A plug-in's triangulator as a function from points to triangles.
#pragma once

#include "algorithms/plugin/tribunal_triangulator.h"
#include "algorithms/triangulation.hpp"
#include "predicates/plugin/library.hpp"
#include "predicates/point.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribunal {

/// What a plug-in's triangulator said, unchecked: corners may be out of range, in either orientation.
struct PluginMesh {
  int ending = TRIBUNAL_DONE;
  std::vector<Triangle> triangles;  ///< at most 2n: no triangulation of n points has more
  std::uint64_t emitted = 0;        ///< triangles given, those that were not kept included
};

/// The triangulator that a shared library offers (tribunal_triangulator.h). Its code is an outsider's: a call
/// may crash or never return.
class TriangulatorPlugin {
 public:
  /// Nothing when the library defines no tribunal_triangulator_entry. Throws PluginError when it defines one
  /// of another version, without a name or without a function.
  static std::optional<TriangulatorPlugin> load(const SharedLibrary& library);

  std::string name() const { return offer_->name; }
  std::string cites() const { return offer_->cites != nullptr ? offer_->cites : ""; }
  std::string summary() const { return offer_->summary != nullptr ? offer_->summary : ""; }

  PluginMesh triangulate(std::span<const Point2> points) const;

 private:
  explicit TriangulatorPlugin(const tribunal_triangulator& offer) : offer_(&offer) {}

  const tribunal_triangulator* offer_;
};

}  // namespace tribunal
