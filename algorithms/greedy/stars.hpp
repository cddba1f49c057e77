// T as seen from every site: Gilbert's Step 5 (1979).
#pragma once

#include "algorithms/greedy/from_pool.hpp"

#include <cstdint>
#include <vector>

namespace tribunal {

/// For each site a segment tree over the directions in which it sees the others, counter-clockwise. An edge
/// of T hides a range of them, strictly between its ends; it hangs at the O(log n) nodes that make up the
/// range. Edges of T do not cross, so that of several at a node one is closest along all its directions: it
/// alone is kept. A segment conflicts with T when an edge on its path from leaf to root separates its ends.
///
/// O(log n) for a question, O(n log n) for an edge; O(n^2 log n) and 12 n^2 bytes to set up.
class Stars final : public AcceptedEdges {
 public:
  explicit Stars(const PlanarProblem& problem);

  bool conflicts(const Edge& segment) override;
  void insert(const Edge& segment) override;

  std::uint64_t tests() const { return tests_; }
  std::uint64_t steps() const { return steps_; }

 private:
  struct Star {
    std::vector<Index> direction;  // by local number of the site seen, counter-clockwise; sites in line share
    std::vector<Index> closest;    // the tree: node 1 is the root, the leaf of direction d is size + d
    std::vector<bool> hidden;      // by local number: another site stands before it
    Index directions = 0;
  };

  Star star_of(Index site) const;
  void hide_between(Index site, Index right, Index left, Index edge);
  void hide_range(Index site, Index first, Index last, Index edge);
  bool is_closer(Index edge, Index other, Index site);
  bool separates(Index edge, Index a, Index b);
  Sign side(Index edge, Index site) const;

  static constexpr Index none = 0xFFFFFFFF;

  const PlanarProblem& problem_;
  std::vector<Index> local_;  // by index: the site's position in problem.sites
  std::vector<Star> stars_;   // by local number
  std::vector<Edge> edges_;   // T
  std::uint64_t tests_ = 0, steps_ = 0;
};

}  // namespace tribunal
