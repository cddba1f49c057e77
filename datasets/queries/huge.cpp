// The upper end of the range: coordinates whose differences overflow, or determinants that do.
#include "datasets/queries/extreme.hpp"
#include "datasets/queries/families.hpp"

namespace tribunal::queries {
namespace {
template <int D>
void draw(Predicate predicate, Random& random, std::span<Point<D>> points) {
  const auto below = static_cast<int>(random.below(4));
  draw_extreme(predicate, random, points, 1003 - below, 1024);
}
}  // namespace

constinit const QueryFamily huge{"huge", "coordinates or determinants near overflow", draw<2>, draw<3>};

}  // namespace tribunal::queries
