// Random integers of 53 bits: the widest that doubles hold.
#include "datasets/queries/families.hpp"
#include "datasets/queries/random_integers.hpp"

namespace tribunal::queries {

constinit const QueryFamily int53{"int53", "random integers in [0, 2^53)", draw_integers<53, 2>,
                                  draw_integers<53, 3>};

}  // namespace tribunal::queries
