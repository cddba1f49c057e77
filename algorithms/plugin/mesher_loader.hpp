// A plug-in's mesher as functions from points with segments to triangles.
#pragma once

#include "algorithms/constrained/graph.hpp"
#include "algorithms/plugin/tribunal_mesher.h"
#include "algorithms/triangulation.hpp"
#include "predicates/plugin/library.hpp"
#include "predicates/point.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tribunal {

/// What a plug-in's mesher said, unchecked: indices may be out of range, coordinates may be no numbers.
struct PluginGraphMesh {
  int ending = TRIBUNAL_DONE;
  std::vector<Point2> vertices;  ///< new ones: their numbers go on where those of the graph's points end
  std::vector<Triangle> triangles;
  std::vector<Edge> subsegments;
};

/// The mesher that a shared library offers (tribunal_mesher.h). Its code is an outsider's: a call may crash,
/// never return, or fill the memory.
class MesherPlugin {
 public:
  /// Nothing when the library defines no tribunal_mesher_entry. Throws PluginError when it defines one of
  /// another version, without a name or without any function.
  static std::optional<MesherPlugin> load(const SharedLibrary& library);

  std::string name() const { return offer_->name; }
  std::string cites() const { return offer_->cites != nullptr ? offer_->cites : ""; }
  std::string summary() const { return offer_->summary != nullptr ? offer_->summary : ""; }
  bool triangulates() const { return offer_->triangulate != nullptr; }
  bool refines() const { return offer_->refine != nullptr; }

  /// The mesher must offer it. The graph's domain is left out of account: the interface says which it is.
  PluginGraphMesh triangulate(const Graph& graph) const;
  PluginGraphMesh refine(const Graph& graph, const tribunal_bounds& bounds) const;

 private:
  explicit MesherPlugin(const tribunal_mesher& offer) : offer_(&offer) {}

  const tribunal_mesher* offer_;
};

}  // namespace tribunal
