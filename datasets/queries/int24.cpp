// Random integers of 24 bits: single precision.
#include "datasets/queries/families.hpp"
#include "datasets/queries/random_integers.hpp"

namespace tribunal::queries {

constinit const QueryFamily int24{"int24", "random integers in [0, 2^24)", draw_integers<24, 2>,
                                  draw_integers<24, 3>};

}  // namespace tribunal::queries
