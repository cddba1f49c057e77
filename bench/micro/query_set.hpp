// The queries of one cell of the micro benchmark.
#pragma once

#include "datasets/queries/queries.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/point.hpp"
#include "predicates/predicate.hpp"
#include "predicates/sign.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::bench {

/// `count` queries of one predicate, their points one after the other. One of the vectors is empty.
struct QuerySet {
  Predicate predicate;
  std::size_t count;
  std::vector<Point2> planar;
  std::vector<Point3> spatial;

  template <int D>
  std::span<const Point<D>> points() const {
    if constexpr (D == 2) return planar;
    if constexpr (D == 3) return spatial;
  }
  /// The same as arguments of their formula, in place: subjects that all read one copy keep it in the caches.
  template <class Formula>
  std::span<const Query<Formula>> arguments() const {
    static_assert(sizeof(Query<Formula>) == Formula::points * sizeof(Point<Formula::dimension>));
    return {reinterpret_cast<const Query<Formula>*>(points<Formula::dimension>().data()), count};
  }
  /// All coordinates, as a C interface takes them.
  const double* coordinates() const {
    return dimension_of(predicate) == 2 ? planar.data()->coordinate.data()
                                        : spatial.data()->coordinate.data();
  }
};

/// Same arguments, same bytes.
QuerySet draw_query_set(const QueryFamily& family, Predicate predicate, std::size_t count,
                        std::uint64_t seed);

/// The true signs, by integers of unbounded size.
std::vector<Sign> exact_signs(const QuerySet& queries);

}  // namespace tribunal::bench
