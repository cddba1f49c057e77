// Exactly degenerate integers with one coordinate of one point moved by an ulp.
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/degenerate_integers.hpp"
#include "datasets/queries/families.hpp"

#include <cmath>
#include <limits>

namespace tribunal::queries {
namespace {
template <int D>
void draw(Predicate predicate, Random& random, std::span<Point<D>> points) {
  draw_degenerate_integers(predicate, random, points);
  double& moved = points[random.below(points.size())][random.below(D)];
  constexpr double infinity = std::numeric_limits<double>::infinity();
  moved = std::nextafter(moved, coin(random) ? infinity : -infinity);
}
}  // namespace

constinit const QueryFamily tinyoff{
    "tinyoff", "exactly degenerate integers with one coordinate moved by an ulp", draw<2>, draw<3>};

}  // namespace tribunal::queries
