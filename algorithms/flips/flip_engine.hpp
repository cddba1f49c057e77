// Lawson's algorithm over any criterion: flip what improves until nothing does.
#pragma once

#include "algorithms/abandon.hpp"
#include "algorithms/flips/criterion.hpp"
#include "algorithms/flips/quadrilateral.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tribunal {

struct FlipCounts {
  std::uint64_t flips = 0;
  std::uint64_t tests = 0;            ///< edges of which the criterion was asked
  std::uint64_t convexity_tests = 0;  ///< edges of which convexity was asked first
  std::uint64_t sweeps = 0;           ///< passes over all edges, the last one without a flip included
};

/// In which order a sweep visits the edges there are when it begins.
enum class Scan : std::uint8_t {
  ascending,   ///< sorted by their ends, (smaller, larger) index
  descending,  ///< the other way round
  shuffled,    ///< at random, anew in every sweep
};

/// Flips the edges of a triangulation while the criterion says that this improves it. Hull edges and fixed
/// ones are left alone. Ends in a local optimum: no edge that may be flipped improves. Abandons when the
/// budget of flips runs out or two triangles come to lie on each other, which both take wrong signs.
template <FlipCriterion Criterion>
class FlipEngine {
 public:
  /// At most `most_flips`; `fixed`, by edge, is not 0 where an edge must stay, and empty where all may go.
  FlipEngine(const Sites& sites, EdgeMesh& mesh, Criterion& criterion, std::uint64_t most_flips,
             std::span<const char> fixed = {})
      : sites_(sites), mesh_(mesh), criterion_(criterion), fixed_(fixed), budget_(most_flips, "flipping") {}

  /// Tests all edges, and those around a flip again. O((edges + flips) tests).
  void flip_from_stack() {
    std::vector<Index> stack;
    for (Index edge = mesh_.edges(); edge-- > 0;) stack.push_back(edge);
    flip_from_stack(std::move(stack));
  }

  /// Tests the edges given, the last one first, and those around a flip.
  void flip_from_stack(std::vector<Index> stack) {
    std::vector<char> waiting(mesh_.edges(), 0);
    for (const Index edge : stack) waiting[edge] = 1;
    while (!stack.empty()) {
      const Index edge = stack.back();
      stack.pop_back();
      waiting[edge] = 0;
      if (!flip_if_better(edge)) continue;
      visit_suspects<Criterion::reach>(mesh_, edge, [&](Index suspect) {
        if (std::exchange(waiting[suspect], 1) == 0) stack.push_back(suspect);
      });
    }
  }

  /// The text's loops: while something was flipped, do all edges. O(edges) tests each.
  void flip_in_sweeps(Scan scan, std::uint64_t seed = 0) {
    Random random(seed);
    for (bool flipped = true; flipped;) {
      flipped = false;
      ++counts_.sweeps;
      for (const Index edge : snapshot(scan, random)) flipped |= flip_if_better(edge);
    }
  }

  const FlipCounts& counts() const { return counts_; }

 private:
  bool flip_if_better(Index edge) {
    if (!mesh_.is_inner(edge) || (!fixed_.empty() && fixed_[edge] != 0)) return false;
    const Quadrilateral q = quadrilateral(mesh_, edge);
    if (q.left == q.right)
      throw Abandon(Outcome::inconsistent_predicate, "two triangles have the same corners");
    if constexpr (!Criterion::implies_convexity) {
      ++counts_.convexity_tests;
      if (!is_strictly_convex(sites_, q)) return false;
    }
    ++counts_.tests;
    if (!criterion_.improves(mesh_, edge)) return false;
    budget_.spend();
    mesh_.flip(edge);
    ++counts_.flips;
    if constexpr (requires { criterion_.flipped(mesh_, edge); }) criterion_.flipped(mesh_, edge);
    return true;
  }

  /// A flip changes the edge whose turn it is and no other: a list made before the sweep serves all of it.
  std::vector<Index> snapshot(Scan scan, Random& random) const {
    std::vector<std::pair<Edge, Index>> by_ends;
    for (Index edge = 0; edge < mesh_.edges(); ++edge) {
      by_ends.emplace_back(undirected(mesh_.from(2 * edge), mesh_.to(2 * edge)), edge);
    }
    std::sort(by_ends.begin(), by_ends.end());
    std::vector<Index> edges;
    edges.reserve(by_ends.size());
    for (const auto& [ends, edge] : by_ends) edges.push_back(edge);
    if (scan == Scan::descending) std::reverse(edges.begin(), edges.end());
    if (scan == Scan::shuffled) random.shuffle(std::span(edges));
    return edges;
  }

  Sites sites_;
  EdgeMesh& mesh_;
  Criterion& criterion_;
  std::span<const char> fixed_;
  Budget budget_;
  FlipCounts counts_;
};

}  // namespace tribunal
