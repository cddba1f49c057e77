// How a sign can be wrong.
#pragma once

#include "predicates/sign.hpp"

#include <map>
#include <string>

namespace tribunal::bench {

struct SignErrors {
  double false_zero = 0;     ///< 0 where the exact sign is not
  double inverted = 0;       ///< + for - or - for +
  double false_nonzero = 0;  ///< + or - where the exact sign is 0

  void note(Sign got, Sign exact) {
    if (got == exact) return;
    if (got == Sign::zero)
      ++false_zero;
    else if (exact == Sign::zero)
      ++false_nonzero;
    else
      ++inverted;
  }
  double wrong() const { return false_zero + inverted + false_nonzero; }

  void add_to(std::map<std::string, double>& counters) const {
    counters["wrong"] = wrong();
    counters["false_zero"] = false_zero;
    counters["inverted"] = inverted;
    counters["false_nonzero"] = false_nonzero;
  }
};

}  // namespace tribunal::bench
