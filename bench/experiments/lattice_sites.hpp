// The cell's points as integers, for experiments whose oracle is integer arithmetic.
#pragma once

#include "algorithms/algorithm.hpp"
#include "bench/input.hpp"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tribunal::bench {

inline constexpr int most_lattice_bits = 24;  // products of differences then fit 64 bits

struct LatticeSite {
  std::int64_t x, y;
};

/// Twice the area of abc.
constexpr std::int64_t doubled_area(const LatticeSite& a, const LatticeSite& b, const LatticeSite& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Distinct points of [0, 2^bits)^2 with their integers, in an order whose first three are not collinear.
struct LatticeSet {
  std::vector<Point2> points;
  std::vector<LatticeSite> sites;
  std::vector<Index> order;
  bool planar = false;  ///< false: all on a line

  explicit LatticeSet(const Cell& cell) : points(distinct_points(cell_points(cell))), order(points.size()) {
    for (const Point2& p : points)
      sites.push_back({static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1])});
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t i = 2; i < points.size() && !planar; ++i) {
      planar = doubled_area(sites[0], sites[1], sites[i]) != 0;
      if (planar) std::swap(order[2], order[i]);
    }
  }
};

}  // namespace tribunal::bench
