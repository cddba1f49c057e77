// Exponents all over the place, from 2^-1000 to 2^1000: differences swallow one coordinate whole.
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/families.hpp"

namespace tribunal::queries {
namespace {
template <int D>
void draw(Predicate, Random& random, std::span<Point<D>> points) {
  each_coordinate(points, [&] { return mixed_exponent(random, 1000); });
}
}  // namespace

constinit const QueryFamily mix300{
    "mix300", "random signs, mantissas and exponents, 2^-1000 to 2^1000 (1e+-300)", draw<2>, draw<3>};

}  // namespace tribunal::queries
