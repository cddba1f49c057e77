// The ulp grids of Kettner, Mehlhorn, Pion, Schirra and Yap (2008), and their like for the other predicates:
// one point close to (1/2, ..., 1/2), on multiples of 2^-53, and far ones degenerate with that point.
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/families.hpp"

#include <algorithm>
#include <array>

namespace tribunal::queries {
namespace {

/// Far points and the pixels around the near one; ties are the pixels on a line or plane, for circle and
/// sphere the middle one alone.
template <int Points, int D>
struct Neighbourhood {
  std::array<Point<D>, Points> far;
  std::int64_t first_pixel, last_pixel;  ///< per axis
};

constexpr Neighbourhood<2, 2> line{{{{{12, 12}}, {{24, 24}}}}, 0, 255};  // set 2a
constexpr Neighbourhood<3, 2> circle{{{{{3.5, 0.5}}, {{3.5, 3.5}}, {{0.5, 3.5}}}}, -8, 8};
constexpr Neighbourhood<3, 3> plane{{{{{12, 12, 12}}, {{24, 24, 24}}, {{12, 24, 36}}}}, 0, 255};
constexpr Neighbourhood<4, 3> sphere{
    {{{{3.5, 0.5, 0.5}}, {{0.5, 3.5, 0.5}}, {{0.5, 0.5, 3.5}}, {{3.5, 3.5, 3.5}}}}, -4, 4};

template <int Points, int D>
void draw_pixel(const Neighbourhood<Points, D>& around, Random& random, std::span<Point<D>> points) {
  std::copy(around.far.begin(), around.far.end(), points.begin());
  for (double& c : points.back().coordinate)
    c = 0.5 + 0x1p-53 * static_cast<double>(integer_between(random, around.first_pixel, around.last_pixel));
  random.shuffle(points);
}

void draw2(Predicate predicate, Random& random, std::span<Point2> points) {
  predicate == Predicate::orient2d ? draw_pixel(line, random, points) : draw_pixel(circle, random, points);
}

void draw3(Predicate predicate, Random& random, std::span<Point3> points) {
  predicate == Predicate::orient3d ? draw_pixel(plane, random, points) : draw_pixel(sphere, random, points);
}
}  // namespace

constinit const QueryFamily kettner{"kettner", "ulp grids around a point degenerate with far ones", draw2,
                                    draw3};

}  // namespace tribunal::queries
