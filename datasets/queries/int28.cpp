// Random integers of 28 bits: the redundant example of the text.
#include "datasets/queries/families.hpp"
#include "datasets/queries/random_integers.hpp"

namespace tribunal::queries {

constinit const QueryFamily int28{"int28", "random integers in [0, 2^28)", draw_integers<28, 2>,
                                  draw_integers<28, 3>};

}  // namespace tribunal::queries
