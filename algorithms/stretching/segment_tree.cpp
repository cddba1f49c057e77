#include "algorithms/stretching/segment_tree.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace tribunal::stretching {
namespace {
constexpr std::uint32_t leaf_size = 4;

double middle(const Segment& s, std::size_t axis) { return s[0][axis] + s[1][axis]; }

/// From the box to p.
double squared_distance(Point2 low, Point2 high, Point2 p) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double beyond = std::max({low[axis] - p[axis], p[axis] - high[axis], 0.0});
    sum += beyond * beyond;
  }
  return sum;
}

Nearest from_place(Point2 place, Point2 p) {
  const double dx = p[0] - place[0], dy = p[1] - place[1];
  const double distance = std::sqrt(dx * dx + dy * dy);
  return {distance, distance > 0 ? std::array{dx / distance, dy / distance} : std::array{0.0, 0.0}};
}
}  // namespace

Nearest nearest_on(const Segment& segment, Point2 p) {
  const auto& [a, b] = segment;
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = p[0] - a[0], vy = p[1] - a[1];
  const double along = ux * vx + uy * vy, squared_length = ux * ux + uy * uy;
  if (along <= 0) return from_place(a, p);
  if (along >= squared_length) return from_place(b, p);
  const double length = std::sqrt(squared_length), left = (ux * vy - uy * vx) / length;
  if (left == 0) return {};
  const double side = left > 0 ? 1 : -1;
  return {side * left, {side * -uy / length, side * ux / length}};
}

SegmentTree::SegmentTree(std::span<const Segment> segments)
    : segments_(segments.begin(), segments.end()), order_(segments.size()) {
  assert(!segments.empty());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.push_back({{}, {}, 0, static_cast<std::uint32_t>(segments.size())});
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) split(node);
}

void SegmentTree::fit(Node& node) const {
  node.low = node.high = segments_[order_[node.begin]][0];
  for (std::uint32_t i = node.begin; i < node.end; ++i)
    for (const Point2& end : segments_[order_[i]])
      for (std::size_t axis = 0; axis < 2; ++axis) {
        node.low[axis] = std::min(node.low[axis], end[axis]);
        node.high[axis] = std::max(node.high[axis], end[axis]);
      }
}

void SegmentTree::split(std::uint32_t node) {
  Node& parent = nodes_[node];
  fit(parent);
  if (parent.end - parent.begin <= leaf_size) return;
  const std::size_t axis = parent.high[0] - parent.low[0] < parent.high[1] - parent.low[1] ? 1 : 0;
  const std::uint32_t begin = parent.begin, end = parent.end, half = begin + (end - begin) / 2;
  const auto at = [this](std::uint32_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](std::uint32_t i, std::uint32_t j) {
    const double a = middle(segments_[i], axis), b = middle(segments_[j], axis);
    return a < b || (a == b && i < j);
  });
  parent.children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, {}, begin, half});
  nodes_.push_back({{}, {}, half, end});
}

Nearest SegmentTree::nearest(Point2 p) const {
  Nearest best{.distance = std::numeric_limits<double>::infinity()};
  std::vector<std::pair<double, std::uint32_t>> open{{0, 0}};
  while (!open.empty()) {
    const auto [bound, index] = open.back();
    open.pop_back();
    // Distances are rounded: a box that seems barely too far is looked into.
    if (bound > best.distance * best.distance * (1 + 0x1p-48)) continue;
    const Node& node = nodes_[index];
    if (node.children == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        Nearest found = nearest_on(segments_[order_[i]], p);
        found.segment = order_[i];
        if (found.distance < best.distance ||
            (found.distance == best.distance && found.segment < best.segment))
          best = found;
      }
      continue;
    }
    std::array<std::pair<double, std::uint32_t>, 2> children;
    for (std::uint32_t i = 0; i < 2; ++i) {
      const Node& child = nodes_[node.children + i];
      children[i] = {squared_distance(child.low, child.high, p), node.children + i};
    }
    if (children[0].first < children[1].first) std::swap(children[0], children[1]);
    open.insert(open.end(), children.begin(), children.end());  // the nearer one is looked into first
  }
  return best;
}

}  // namespace tribunal::stretching
