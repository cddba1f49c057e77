// Random integers of 36 bits: truncated doubles.
#include "datasets/queries/families.hpp"
#include "datasets/queries/random_integers.hpp"

namespace tribunal::queries {

constinit const QueryFamily int36{"int36", "random integers in [0, 2^36)", draw_integers<36, 2>,
                                  draw_integers<36, 3>};

}  // namespace tribunal::queries
