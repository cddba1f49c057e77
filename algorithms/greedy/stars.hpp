// T as seen from every site: Gilbert's Step 5 (1979).
#pragma once

#include "algorithms/greedy/from_pool.hpp"

#include <array>
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
  static constexpr Index none = 0xFFFFFFFF;

  struct Star {
    std::vector<Index> direction;  // by local number of the site seen, counter-clockwise; sites in line share
    std::vector<Index> closest;    // the tree: node 1 is the root, the leaf of direction d is size + d
    std::vector<bool> hidden;      // by local number: another site stands before it
    Index directions = 0;
  };

  /// An edge as a site sees it that is not on its line.
  struct Sight {
    Index edge, site;
    Sign front;  // the side of the edge that the site is on
  };

  /// Where the ends of an edge of T and of the one being inserted lie, each from the line of the other: the
  /// same whichever site asks, and so kept while the insertion lasts.
  struct Mutual {
    Index inserted = none;  // the insertion it was computed for
    std::array<Sign, 2> older = {}, newer = {};
  };

  Star star_of(Index site) const;
  void hide(const Sight& sight);
  void hide_range(const Sight& sight, Index first, Index last);
  bool is_closer(const Sight& sight, Index other);
  const Mutual& mutual(Index inserted, Index other);
  bool separates(Index edge, Index a, Index b);
  Sign side(Index edge, Index site) const;

  const PlanarProblem& problem_;
  std::vector<Index> local_;    // by index: the site's position in problem.sites
  std::vector<Star> stars_;     // by local number
  std::vector<Edge> edges_;     // T
  std::vector<Mutual> mutual_;  // by edge of T
  std::uint64_t tests_ = 0, steps_ = 0;
};

}  // namespace tribunal
