// From the exact checker's verdict to the outcome of a row.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/verify/verify.hpp"
#include "predicates/point.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace tribunal::bench {

struct Judgement {
  Outcome outcome = Outcome::ok;
  std::string reason;      ///< the first fault, where the outcome is not ok
  std::uint64_t ties = 0;  ///< cocircular quadruples across interior edges
};

/// A site left out explains a wrong count and a wrong hull, so `missing_site` is the outcome where nothing
/// else is wrong with the topology; `non_delaunay` is said of valid triangulations only.
Judgement judgement_of(const verify::Verdict& verdict);

/// Checks a finished triangulation for what its algorithm promises.
Judgement judge(std::span<const Point2> points, const Triangulation& triangulation,
                Promise promise = Promise::delaunay);

}  // namespace tribunal::bench
