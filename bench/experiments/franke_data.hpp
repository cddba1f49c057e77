// Scattered data with a known function behind them, for experiments on data-dependent triangulation.
#pragma once

#include "algorithms/data_dependent/franke.hpp"
#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/row.hpp"
#include "datasets/random.hpp"

#include <numeric>
#include <string_view>
#include <vector>

namespace tribunal::bench {

constexpr Parameter function_parameter{
    .name = "data", .summary = "the function", .standard = "F2", .choices = [] {
      std::vector<std::string_view> names;
      for (const FrankeFunction& function : franke_functions()) names.push_back(function.name);
      return names;
    }};

inline const FrankeFunction& chosen_function(const Cell& cell) {
  return franke_functions()[choice_index(cell.parameters, function_parameter)];
}

/// The corners of the unit square and n - 4 random points of it.
inline std::vector<Point2> corners_and_random_points(std::uint64_t n, std::uint64_t seed) {
  std::vector<Point2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Random random(seed);
  while (points.size() < n) {
    const double x = random.unit(), y = random.unit();
    points.push_back({x, y});
  }
  return points;
}

/// In the order of the points.
inline Triangulation delaunay_of(const std::vector<Point2>& points, const Kernel2& kernel) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  return triangulate(points, order, kernel, *find_planar_algorithm("green-sibson"));
}

}  // namespace tribunal::bench
