// One query out of many that stand one after the other.
#pragma once

#include "predicates/formulas/query.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace tribunal::bench {

/// The i-th of the queries whose points stand one after the other.
template <class Formula>
Query<Formula> query_at(std::span<const Point<Formula::dimension>> points, std::size_t i) {
  Query<Formula> query;
  std::copy_n(points.begin() + i * Formula::points, Formula::points, query.begin());
  return query;
}

}  // namespace tribunal::bench
