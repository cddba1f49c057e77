// A plug-in's triangulator.
#pragma once

#include "bench/outsider/triangulator.hpp"

#include <string>
#include <utility>

namespace tribunal::bench {

/// Loads the library anew in each process that it works in. triangulate throws PluginError when the library
/// cannot be used; its time is processor time of the call alone.
class PluginTriangulator final : public Triangulator {
 public:
  explicit PluginTriangulator(std::string path) : path_(std::move(path)) {}
  OutsiderMesh triangulate(std::span<const Point2> points) const override;
  int spare_runs() const override { return 4000; }
  std::string options() const override;

 private:
  std::string path_;
};

}  // namespace tribunal::bench
