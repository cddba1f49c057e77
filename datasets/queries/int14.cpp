// Random integers of 14 bits: what Knuth's 32-bit words hold.
#include "datasets/queries/families.hpp"
#include "datasets/queries/random_integers.hpp"

namespace tribunal::queries {

constinit const QueryFamily int14{"int14", "random integers in [0, 2^14)", draw_integers<14, 2>,
                                  draw_integers<14, 3>};

}  // namespace tribunal::queries
