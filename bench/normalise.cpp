#include "bench/normalise.hpp"

#include "algorithms/duplicates.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/formulas/orient.hpp"

#include <algorithm>
#include <utility>

namespace tribunal::bench {

std::vector<Triangle> normalise(std::span<const Point2> points, std::vector<Triangle> triangles) {
  const std::vector<Index> first = first_occurrences(points);
  for (Triangle& t : triangles) {
    if (std::ranges::any_of(t, [&](Index corner) { return corner >= points.size(); })) continue;
    for (Index& corner : t) corner = first[corner];
    if (exact_sign<Orient<2>>({points[t[0]], points[t[1]], points[t[2]]}) == Sign::negative)
      std::swap(t[1], t[2]);
  }
  return canonical(triangles);
}

}  // namespace tribunal::bench
