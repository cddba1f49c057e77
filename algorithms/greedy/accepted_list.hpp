// T as a list of edges: the naive Step 5.
#pragma once

#include "algorithms/greedy/conflict.hpp"
#include "algorithms/greedy/from_pool.hpp"

#include <cstdint>
#include <vector>

namespace tribunal {

/// Tries the segment against every edge of T: O(n) per candidate, O(n^3) in all. A crossing settles the
/// question; with `full_scan` the rest of the list is tried all the same, as a plain reading of Step 5 has
/// it.
class AcceptedList final : public AcceptedEdges {
 public:
  AcceptedList(const PlanarProblem& problem, bool full_scan) : problem_(problem), full_scan_(full_scan) {}

  bool conflicts(const Edge& segment) override {
    bool found = false;
    for (const Edge& edge : edges_) {
      if (found && !full_scan_) break;
      ++tests_;
      found = segments_conflict(problem_, segment, edge) || found;
    }
    return found;
  }
  void insert(const Edge& segment) override { edges_.push_back(segment); }

  std::uint64_t tests() const { return tests_; }

 private:
  const PlanarProblem& problem_;
  bool full_scan_;
  std::vector<Edge> edges_;
  std::uint64_t tests_ = 0;
};

}  // namespace tribunal
