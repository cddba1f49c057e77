#include "bench/micro/query_set.hpp"

#include "predicates/backends/exact_sign.hpp"
#include "predicates/formulas/with_formula.hpp"

#include <algorithm>

namespace tribunal::bench {

QuerySet draw_query_set(const QueryFamily& family, Predicate predicate, std::size_t count,
                        std::uint64_t seed) {
  QuerySet queries{predicate, count, {}, {}};
  if (dimension_of(predicate) == 2)
    queries.planar = draw_queries2(family, predicate, count, seed);
  else
    queries.spatial = draw_queries3(family, predicate, count, seed);
  return queries;
}

std::vector<Sign> exact_signs(const QuerySet& queries) {
  std::vector<Sign> signs(queries.count);
  with_formula(queries.predicate, [&]<class Formula>() {
    std::transform(queries.arguments<Formula>().begin(), queries.arguments<Formula>().end(), signs.begin(),
                   exact_sign<Formula>);
  });
  return signs;
}

}  // namespace tribunal::bench
