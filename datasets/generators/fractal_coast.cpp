// A coast by midpoint displacement (Fournier, Fussell, Carpenter 1982): a square's sides are halved again and
// again, each middle moved by a random distance that shrinks with a power of the length; what would touch
// the coast elsewhere is drawn again.
#include "datasets/generators/generators.hpp"
#include "datasets/random.hpp"
#include "datasets/shapes/outline.hpp"
#include "datasets/shapes/pslg_points.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/kernel.hpp"

#include <algorithm>

namespace tribunal {
namespace {
constexpr double shrink = 0.5743491774985174;  // 2^-H for H = 0.8
constexpr std::size_t most_displaced = 4096;   // vertices; beyond, sides are halved where they are

class Coast {
 public:
  explicit Coast(std::uint64_t seed)
      : random_(seed),
        coast_{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}},
        kernel_(find_backend("filtered")->bind2(std::array{Point2{{-2, -2}}, Point2{{3, 3}}})) {}

  shapes::Outline grow(std::uint64_t n) {
    while (coast_.size() < n) {
      shapes::Outline finer;
      for (std::size_t i = 0; i < coast_.size(); ++i) {
        finer.push_back(coast_[i]);
        finer.push_back(middle(i, finer));
      }
      coast_ = std::move(finer);
      reach_ *= shrink;
    }
    return coast_;
  }

 private:
  Point2 middle(std::size_t i, const shapes::Outline& before) {
    const Point2 a = coast_[i], b = coast_[(i + 1) % coast_.size()];
    const Point2 straight{{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}};
    if (coast_.size() > most_displaced) return straight;
    double reach = reach_;
    for (int attempt = 0; attempt < 8; ++attempt, reach /= 2) {
      const Point2 p{
          {straight[0] + reach * (2 * random_.unit() - 1), straight[1] + reach * (2 * random_.unit() - 1)}};
      if (is_free(a, p, i, before) && is_free(b, p, i, before)) return p;
    }
    return straight;
  }

  /// Whether the segment from an end of side i to p meets nothing but that end: neither what has been made
  /// finer nor the sides that are still to come.
  bool is_free(Point2 end, Point2 p, std::size_t i, const shapes::Outline& before) const {
    for (std::size_t k = 0; k + 1 < before.size(); ++k)
      if (meet(end, p, before[k], before[k + 1])) return false;
    for (std::size_t k = i + 1; k < coast_.size(); ++k)
      if (meet(end, p, coast_[k], coast_[(k + 1) % coast_.size()])) return false;
    return true;
  }
  bool meet(Point2 end, Point2 p, Point2 c, Point2 d) const {
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (std::max(end[axis], p[axis]) < std::min(c[axis], d[axis]) ||
          std::max(c[axis], d[axis]) < std::min(end[axis], p[axis]))
        return false;
    const Kernel2& kernel = *std::get<0>(kernel_);
    const Sign at_p = kernel.orient2d(c, d, p);
    if (end == c || end == d) return at_p == Sign::zero;  // neighbours: only along each other
    return kernel.orient2d(c, d, end) != at_p && kernel.orient2d(end, p, c) != kernel.orient2d(end, p, d);
  }

  Random random_;
  shapes::Outline coast_;
  Kernel2Binding kernel_;
  double reach_ = 0.15;
};

DatasetGraph graph(std::uint64_t n, std::uint64_t seed) {
  DatasetGraph domain;
  shapes::add_loop(domain, Coast(seed).grow(std::max<std::uint64_t>(n, 4)));
  return domain;
}

}  // namespace

constinit const Dataset generators::fractal_coast{
    .about = {.name = "fractal-coast",
              .cites = "Fournier, Fussell, Carpenter 1982",
              .summary = "an island with a coast by midpoint displacement: bays within bays",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n, std::uint64_t seed) { return shapes::first_points(graph(n, seed), n); },
    .graph = graph,
};

}  // namespace tribunal
