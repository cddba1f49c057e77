// Exactly degenerate doubles whose differences round: every sign is zero, but the first subtraction already
// loses it.
#include "datasets/queries/coordinates.hpp"
#include "datasets/queries/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tribunal::queries {
namespace {

/// Random, odd, of exactly `bits` bits and either sign: none of its bits is spare.
std::int64_t odd_integer(Random& random, int bits) {
  const std::uint64_t leading = std::uint64_t{1} << (bits - 1);
  const auto magnitude = static_cast<std::int64_t>(leading | random.below(leading) | 1);
  return coin(random) ? magnitude : -magnitude;
}

/// The integer times a power of two that differs from those of other `rank`s by a factor of at least 2^3.
/// Numbers of 53 bits that far apart have no exact sum or difference.
double spread(Random& random, std::int64_t integer, int rank) {
  return std::ldexp(static_cast<double>(integer), -8 * rank - static_cast<int>(random.below(6)));
}

/// On a hyperplane through the origin, which is mapped to itself by scaling: random combinations of D - 1
/// vectors, of up to 53 bits, each scaled by a power of two of its own.
template <int D>
void draw_on_plane(Random& random, std::span<Point<D>> points) {
  constexpr int vector_bits = 26, multiple_bits = D == 2 ? 27 : 26;  // two products add up in space
  std::array<std::array<std::int64_t, D>, D - 1> spanning;
  for (auto& v : spanning)
    for (std::int64_t& c : v) c = odd_integer(random, vector_bits);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::array<std::int64_t, D> sum{};
    for (const auto& v : spanning) {
      const std::int64_t multiple = odd_integer(random, multiple_bits);
      for (int axis = 0; axis < D; ++axis) sum[axis] += multiple * v[axis];
    }
    const double scale = spread(random, 1, static_cast<int>(i));
    for (int axis = 0; axis < D; ++axis) points[i][axis] = static_cast<double>(sum[axis]) * scale;
  }
  random.shuffle(points);
}

/// On a sphere around the origin: signed permutations of one vector whose components differ in magnitude.
template <int D>
void draw_on_sphere(Random& random, std::span<Point<D>> points) {
  Point<D> v;
  for (int axis = 0; axis < D; ++axis) v[axis] = spread(random, odd_integer(random, 53), axis);
  for (std::size_t i = 0; i < points.size();) {
    random.shuffle(std::span<double>(v.coordinate));
    for (double& c : v.coordinate) c = coin(random) ? c : -c;
    const auto drawn = points.first(i);
    if (std::find(drawn.begin(), drawn.end(), v) != drawn.end()) continue;
    // The first two differ by a permutation: signs alone would leave all differences exact.
    if (i == 1 && std::fabs(v[0]) == std::fabs(points[0][0])) continue;
    points[i++] = v;
  }
  random.shuffle(points);
}

template <int D>
void draw(Predicate, Random& random, std::span<Point<D>> points) {
  points.size() == D + 1 ? draw_on_plane(random, points) : draw_on_sphere(random, points);
}
}  // namespace

constinit const QueryFamily degF{"degF", "exactly degenerate with differences that round: every sign is zero",
                                 draw<2>, draw<3>};

}  // namespace tribunal::queries
