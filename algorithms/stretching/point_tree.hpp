// A growing set of points that tells whether any lies close to a place.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal::stretching {

/// A tree of cells that are halved across their longer side when they hold too many points (after Bentley
/// 1975, at the middle of the cell and not at a median, so that points may come in any order: the depth is
/// bounded by the logarithm of the box's size over the least distance).
class PointTree {
 public:
  /// For points in this box.
  PointTree(Point2 low, Point2 high);

  /// Adds a point of the box. O(depth).
  void insert(Point2 p);

  /// Whether a point other than `except` is nearer to p than `radius`. Rounded. O(depth) where it is about as
  /// large as the distances between the points there.
  bool any_within(Point2 p, double radius, Point2 except) const;

  std::size_t size() const { return points_.size(); }

 private:
  struct Cell {
    Point2 low, high;
    std::uint32_t children = 0;           // the first of two; 0: a leaf
    std::vector<std::uint32_t> points{};  // of a leaf
  };
  void halve(std::uint32_t cell);

  std::vector<Cell> cells_;
  std::vector<Point2> points_;
};

}  // namespace tribunal::stretching
