// Integer points exactly on one circle around the origin.
//
// The Gaussian integers z with |z|^2 = R^2, R a product of primes p = 1 mod 4, are units times products over
// the primes of pi^k conj(pi)^(2e-k), k = 0..2e, where p = pi conj(pi) and p^e divides R: 4 prod(2e+1) of
// them. The radius is the smallest whose circle holds n points, so coordinates stay as short as they can: 24
// bits with sign for n <= 1,620, 32 for n <= 6,804, and less than 2^53 for 393,660 points, the most there
// are. Which n of the points: drawn by seed.
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace tribunal::generators {
namespace {

struct GaussianInteger {
  std::int64_t re, im;
};
constexpr GaussianInteger operator*(GaussianInteger a, GaussianInteger b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
constexpr GaussianInteger conjugate(GaussianInteger a) { return {a.re, -a.im}; }

/// One prime above each of 5, 13, 17, 29, 37, 41, 53, 61, 73, 89.
constexpr std::array<GaussianInteger, 10> primes{
    {{2, 1}, {3, 2}, {4, 1}, {5, 2}, {6, 1}, {5, 4}, {7, 2}, {6, 5}, {8, 3}, {8, 5}}};

/// Radii below 2^53 whose circles hold more integer points than any smaller circle of integer radius.
constexpr std::array<std::int64_t, 31> radii{5,
                                             25,
                                             65,
                                             325,
                                             1105,
                                             5525,
                                             27625,
                                             32045,
                                             160225,
                                             801125,
                                             1185665,
                                             5928325,
                                             29641625,
                                             48612265,
                                             243061325,
                                             1215306625,
                                             2576450045,
                                             12882250225,
                                             64411251125,
                                             157163452745,
                                             785817263725,
                                             3929086318625,
                                             10215624428425,
                                             11472932050385,
                                             51078122142125,
                                             57364660251925,
                                             286823301259625,
                                             745740583275025,
                                             1021090952484265,
                                             3728702916375125,
                                             5105454762421325};

/// The exponent of each of the primes' norms in the radius.
constexpr std::array<int, primes.size()> factorise(std::int64_t radius) {
  std::array<int, primes.size()> exponents{};
  for (std::size_t i = 0; i < primes.size(); ++i) {
    const std::int64_t norm = (primes[i] * conjugate(primes[i])).re;
    for (; radius % norm == 0; radius /= norm) ++exponents[i];
  }
  return exponents;
}

constexpr std::uint64_t points_on_circle(std::int64_t radius) {
  std::uint64_t count = 4;
  for (const int exponent : factorise(radius)) count *= static_cast<std::uint64_t>(2 * exponent + 1);
  return count;
}

/// All Gaussian integers of absolute value `radius`. No product on the way is longer than the radius.
std::vector<GaussianInteger> circle_points(std::int64_t radius) {
  std::vector<GaussianInteger> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const auto exponents = factorise(radius);
  for (std::size_t i = 0; i < primes.size(); ++i) {
    const int power = 2 * exponents[i];
    std::vector<GaussianInteger> next;
    for (int k = 0; k <= power; ++k) {
      GaussianInteger factor{1, 0};
      for (int j = 0; j < power; ++j) factor = factor * (j < k ? primes[i] : conjugate(primes[i]));
      for (const GaussianInteger point : points) next.push_back(point * factor);
    }
    points = std::move(next);
  }
  return points;
}

std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  const auto enough =
      std::find_if(radii.begin(), radii.end(), [&](auto r) { return points_on_circle(r) >= n; });
  auto lattice = circle_points(enough == radii.end() ? radii.back() : *enough);
  Random(seed).shuffle(std::span(lattice));
  lattice.resize(std::min<std::uint64_t>(n, lattice.size()));
  std::vector<Point2> points;
  points.reserve(lattice.size());
  for (const auto [x, y] : lattice) points.push_back({{static_cast<double>(x), static_cast<double>(y)}});
  return points;
}
}  // namespace

constinit const Dataset circle{
    .about = {.name = "circle",
              .cites = "Gauss (sums of two squares)",
              .summary =
                  "integer points exactly on one circle, at most 393,660: every incircle test is a tie",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
