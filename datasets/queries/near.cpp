// Random degenerate configurations, rounded to double: points of a sphere and the last point of a plane are
// constructed in floating point, so the true sign is that of the rounding errors, hardly ever zero.
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/families.hpp"

#include <cmath>

namespace tribunal::queries {
namespace {

/// A random direction: uniform in the ball by rejection, then normalised.
template <int D>
Point<D> unit_vector(Random& random) {
  for (;;) {
    Point<D> v;
    double squared = 0;
    for (double& c : v.coordinate) {
      c = 2 * random.unit() - 1;
      squared += c * c;
    }
    if (squared > 1 || squared < 0.0625) continue;
    const double length = std::sqrt(squared);
    for (double& c : v.coordinate) c /= length;
    return v;
  }
}

/// Near one sphere of random centre and radius.
template <int D>
void draw_near_sphere(Random& random, std::span<Point<D>> points) {
  Point<D> centre;
  for (double& c : centre.coordinate) c = random.unit();
  const double radius = 0.5 + random.unit();
  for (Point<D>& p : points) {
    p = unit_vector<D>(random);
    for (int axis = 0; axis < D; ++axis) p[axis] = centre[axis] + radius * p[axis];
  }
}

/// Near one hyperplane: the last point is an affine combination of the others.
template <int D>
void draw_near_plane(Random& random, std::span<Point<D>> points) {
  const auto others = points.first(D);
  each_coordinate(others, [&] { return random.unit(); });
  Point<D>& last = points[D] = others[0];
  for (int i = 1; i < D; ++i) {
    const double weight = 2 * random.unit() - 0.5;
    for (int axis = 0; axis < D; ++axis) last[axis] += weight * (others[i][axis] - others[0][axis]);
  }
  random.shuffle(points);
}

template <int D>
void draw(Predicate, Random& random, std::span<Point<D>> points) {
  points.size() == D + 1 ? draw_near_plane(random, points) : draw_near_sphere(random, points);
}
}  // namespace

constinit const QueryFamily near{"near", "random degenerate configurations, rounded to double", draw<2>,
                                 draw<3>};

}  // namespace tribunal::queries
