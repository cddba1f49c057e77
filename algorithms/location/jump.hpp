// Where a walk should start: near its end.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

#include <cstdint>

namespace tribunal {

/// The start of a jump-and-walk (Mücke, Saias, Zhu 1996): of about n^{1/3} triangles taken from all over a
/// mesh without dead slots, the one with a corner nearest to the site. From there a walk over n uniform sites
/// takes O(n^{1/3}) expected steps.
///
/// Distances are plain doubles, rounded and all: a start is a guess, and every guess is right.
class Jump {
 public:
  Jump(const PlanarProblem& problem, const PlanarMesh& mesh) : problem_(problem), mesh_(mesh) {}

  /// The best of the sample and of triangle `t`.
  Index from(Index t, Index site) {
    const std::uint64_t triangles = mesh_.triangles();
    while ((samples_ + 1) * (samples_ + 1) * (samples_ + 1) <= triangles) ++samples_;
    double nearest = distance(t, site);
    for (std::uint64_t k = 0; k < samples_; ++k) {
      // Fractions of a multiple of the golden ratio are spread evenly (Weyl 1916), in each run alike.
      weyl_ += 0x9E3779B97F4A7C15;
      const auto sample = static_cast<Index>((weyl_ >> 32) * triangles >> 32);
      const double far = distance(sample, site);
      if (!(far < nearest)) continue;
      nearest = far;
      t = sample;
    }
    return t;
  }

 private:
  /// Squared, from a finite corner of t.
  double distance(Index t, Index site) const {
    const Index at = mesh_.corner(3 * t) == infinite ? mesh_.corner(3 * t + 1) : mesh_.corner(3 * t);
    const double dx = problem_.points[at][0] - problem_.points[site][0];
    const double dy = problem_.points[at][1] - problem_.points[site][1];
    return dx * dx + dy * dy;
  }

  const PlanarProblem& problem_;
  const PlanarMesh& mesh_;
  std::uint64_t samples_ = 1, weyl_ = 0;
};

}  // namespace tribunal
