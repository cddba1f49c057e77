// Exponents all over the place, from 2^-100 to 2^100: differences swallow one coordinate whole.
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/families.hpp"

namespace tribunal::queries {
namespace {
template <int D>
void draw(Predicate, Random& random, std::span<Point<D>> points) {
  each_coordinate(points, [&] { return mixed_exponent(random, 100); });
}
}  // namespace

constinit const QueryFamily mix30{"mix30", "random signs, mantissas and exponents, 2^-100 to 2^100 (1e+-30)",
                                  draw<2>, draw<3>};

}  // namespace tribunal::queries
