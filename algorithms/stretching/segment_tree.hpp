// How far a point is from the nearest of many segments, and in which direction it lies from there.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::stretching {

using Segment = std::array<Point2, 2>;

/// The scalar S and the unit vector s of Barth, section 3.5, at a point.
struct Nearest {
  double distance = 0;                ///< the least distance to a segment
  std::array<double, 2> direction{};  ///< from the nearest place there; zero on a segment
  std::uint32_t segment = 0;          ///< the first of the nearest ones
};

/// The same of one segment, which has a length. Where the nearest place is between its ends, both come from
/// the line's equation, which keeps them good for points however close to it.
Nearest nearest_on(const Segment& segment, Point2 p);

/// Boxes around halves of the segments, halves of the halves, and so on.
class SegmentTree {
 public:
  /// O(n log n). At least one segment.
  explicit SegmentTree(std::span<const Segment> segments);

  /// Rounded; the same as of the nearest segment alone. O(log n) where segments are spread evenly.
  Nearest nearest(Point2 p) const;

 private:
  struct Node {
    Point2 low, high;            // the box
    std::uint32_t begin, end;    // its segments, in order_
    std::uint32_t children = 0;  // the first of two, one after the other; 0: none
  };
  void split(std::uint32_t node);
  void fit(Node& node) const;

  std::vector<Segment> segments_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace tribunal::stretching
