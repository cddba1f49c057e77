// Ways from a triangulation to one on which the data look smoother.
#pragma once

#include "algorithms/data_dependent/roughness.hpp"
#include "algorithms/flips/flip_engine.hpp"

#include <cstdint>

namespace tribunal {

/// What is flipped, and by what measure.
struct RoughMesh {
  const Sites& sites;
  EdgeMesh& mesh;
  const Roughness& roughness;

  /// Whether the edge may be flipped: it is an inner one, and its quadrilateral is strictly convex.
  bool is_flippable(Index edge) const {
    if (!mesh.is_inner(edge)) return false;
    const Quadrilateral q = quadrilateral(mesh, edge);
    return q.left != q.right && is_strictly_convex(sites, q);
  }
};

/// Always flips the edge that gains most, until none gains. O((m + k) log m) for m edges and k flips. Like
/// all searches below it ends with no single flip that gains, abandons after `most_flips`, and counts flips
/// and tests.
FlipCounts flip_best_first(const RoughMesh& rough, std::uint64_t most_flips);

/// Where no single flip gains, looks two flips ahead: a flip that loses is taken when another one after it,
/// of an edge it has an effect on, gains more than was lost (Dyn, Levin, Rippa 1990 suggest to). Ends with no
/// such pair. O(m) pairs are tried for each that is found.
FlipCounts flip_looking_ahead(const RoughMesh& rough, std::uint64_t most_flips);

struct Cooling {
  std::uint64_t seed = 1;
  int temperatures = 40;
  double factor = 0.85;              ///< from one temperature to the next
  std::uint64_t tries_per_edge = 4;  ///< at each temperature
};

/// Simulated annealing (Schumaker 1993): flips drawn at random are taken when they gain, and with probability
/// exp(-loss / temperature) when they lose. The first temperature is twice the mean change by a flip.
/// Afterwards every flip that gains is taken. Deterministic by its seed where exp is.
FlipCounts anneal(const RoughMesh& rough, std::uint64_t most_flips, const Cooling& cooling);

}  // namespace tribunal
