// Uniform doubles: multiples of 2^-53 in [0, 1).
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/families.hpp"

namespace tribunal::queries {
namespace {
template <int D>
void draw(Predicate, Random& random, std::span<Point<D>> points) {
  each_coordinate(points, [&] { return random.unit(); });
}
}  // namespace

constinit const QueryFamily uni{"uni", "uniform doubles in [0, 1)", draw<2>, draw<3>};

}  // namespace tribunal::queries
