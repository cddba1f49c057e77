// The lower end of the range: coordinates that are multiples of the smallest subnormal number, or
// determinants of that magnitude.
#include "datasets/queries/extreme.hpp"
#include "datasets/queries/families.hpp"

namespace tribunal::queries {
namespace {
template <int D>
void draw(Predicate predicate, Random& random, std::span<Point<D>> points) {
  const auto above = static_cast<int>(random.below(64));  // from all subnormal to mostly normal coordinates
  draw_extreme(predicate, random, points, -1074 + above, -1050);
}
}  // namespace

constinit const QueryFamily tiny{
    "tiny", "coordinates or determinants near or below the smallest normal number", draw<2>, draw<3>};

}  // namespace tribunal::queries
