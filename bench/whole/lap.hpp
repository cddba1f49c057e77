// What a contestant has to show for one run.
#pragma once

#include "algorithms/triangulation.hpp"
#include "bench/sandbox.hpp"
#include "predicates/point.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A mesh over the points of a Ground, unchecked.
struct Lap {
  Outcome outcome = Outcome::ok;
  std::string reason = {};
  std::vector<Triangle> triangles = {};
  double seconds = 0;  ///< processor time of the thread, from input to triangles, both in memory
  std::vector<Point2> vertices = {};   ///< of refinement: new ones, numbered on from the points
  std::vector<Edge> subsegments = {};  ///< of refinement: the edges that are parts of segments
};

/// Runs it once in a process of its own: a crash, a hang and memory without end are outcomes.
Lap run_apart(const std::function<Lap()>& run, const Limits& limits);

/// The same, for the time alone: there is no mesh in what comes back. It is the second run of its process
/// that is timed; the first one has fetched the memory and the code from the system.
Lap time_apart(const std::function<Lap()>& run, const Limits& limits);

}  // namespace tribunal::bench
