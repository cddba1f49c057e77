// Scattered data over a Delaunay triangulation, for tests of flips that look at them.
#pragma once

#include "algorithms/data_dependent/franke.hpp"
#include "algorithms/data_dependent/searches.hpp"
#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/dataset.hpp"
#include "datasets/random.hpp"
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace tribunal::data_dependent {

/// The corners of the unit square and n - 4 random points of it, with a kernel and the Delaunay
/// triangulation.
class Scatter {
 public:
  explicit Scatter(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    while (points.size() < n) {
      const double x = random.unit(), y = random.unit();
      points.push_back({x, y});
    }
    auto bound = find_backend("filtered")->bind2(points);
    kernel_ = std::move(std::get<0>(bound));
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    delaunay = triangulate(points, order, *kernel_, *find_planar_algorithm("green-sibson")).triangles;
  }
  Sites sites() const { return {points, *kernel_}; }

  std::vector<Point2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Triangle> delaunay;

 private:
  std::unique_ptr<const Kernel2> kernel_;
};

}  // namespace tribunal::data_dependent
