// Exactly degenerate integers: every sign is zero.
#include "datasets/queries/degenerate_integers.hpp"
#include "datasets/queries/families.hpp"

namespace tribunal::queries {

constinit const QueryFamily degI{"degI", "exactly degenerate integers below 2^21: every sign is zero",
                                 draw_degenerate_integers, draw_degenerate_integers};

}  // namespace tribunal::queries
