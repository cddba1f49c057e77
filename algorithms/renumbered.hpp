// A problem with its sites numbered as they come: neighbours in time become neighbours in memory.
#pragma once

#include "algorithms/algorithm.hpp"

#include <numeric>
#include <vector>

namespace tribunal {

/// The same problem over a copy of the sites in insertion order, and the way back. Where the order follows a
/// curve through the plane, what an insertion touches then lies together.
class Renumbered {
 public:
  explicit Renumbered(const PlanarProblem& given)
      : given_(given), points_(given.sites.size()), sites_(given.sites.size()) {
    for (std::size_t i = 0; i < points_.size(); ++i) points_[i] = given.points[given.sites[i]];
    std::iota(sites_.begin(), sites_.end(), Index{0});
  }

  PlanarProblem problem() const { return {points_, sites_, given_.kernel, given_.settings}; }

  /// Names the sites of a result as they were given.
  void restore(Triangulation& result) const {
    for (Triangle& t : result.triangles)
      for (Index& corner : t) corner = given_.sites[corner];
  }

 private:
  const PlanarProblem& given_;
  std::vector<Point2> points_;
  std::vector<Index> sites_;
};

}  // namespace tribunal
