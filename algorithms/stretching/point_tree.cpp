#include "algorithms/stretching/point_tree.hpp"

#include <algorithm>

namespace tribunal::stretching {
namespace {
constexpr std::size_t leaf_size = 12;

std::size_t longer_axis(Point2 low, Point2 high) { return high[1] - low[1] > high[0] - low[0] ? 1 : 0; }
double middle(Point2 low, Point2 high, std::size_t axis) { return low[axis] + (high[axis] - low[axis]) / 2; }

double squared_distance(Point2 a, Point2 b) {
  const double dx = a[0] - b[0], dy = a[1] - b[1];
  return dx * dx + dy * dy;
}
}  // namespace

PointTree::PointTree(Point2 low, Point2 high) : cells_{{low, high}} {}

void PointTree::insert(Point2 p) {
  std::uint32_t at = 0;
  while (cells_[at].children != 0) {
    const Cell& cell = cells_[at];
    const std::size_t axis = longer_axis(cell.low, cell.high);
    at = cell.children + (p[axis] >= middle(cell.low, cell.high, axis) ? 1 : 0);
  }
  cells_[at].points.push_back(static_cast<std::uint32_t>(points_.size()));
  points_.push_back(p);
  if (cells_[at].points.size() > leaf_size) halve(at);
}

/// All its points may fall into one half; that one is halved when the next comes.
void PointTree::halve(std::uint32_t cell) {
  const Point2 low = cells_[cell].low, high = cells_[cell].high;
  const std::size_t axis = longer_axis(low, high);
  const double cut = middle(low, high, axis);
  if (!(low[axis] < cut && cut < high[axis])) return;
  std::array<Cell, 2> halves{Cell{low, high}, Cell{low, high}};
  halves[0].high[axis] = halves[1].low[axis] = cut;
  for (const std::uint32_t point : cells_[cell].points)
    halves[points_[point][axis] >= cut ? 1 : 0].points.push_back(point);
  cells_[cell].points = {};
  cells_[cell].children = static_cast<std::uint32_t>(cells_.size());
  for (Cell& half : halves) cells_.push_back(std::move(half));
}

bool PointTree::any_within(Point2 p, double radius, Point2 except) const {
  const double squared = radius * radius;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const Cell& cell = cells_[open.back()];
    open.pop_back();
    if (p[0] + radius < cell.low[0] || cell.high[0] < p[0] - radius || p[1] + radius < cell.low[1] ||
        cell.high[1] < p[1] - radius)
      continue;
    for (const std::uint32_t point : cell.points)
      if (squared_distance(points_[point], p) < squared && points_[point] != except) return true;
    if (cell.children != 0) open.insert(open.end(), {cell.children, cell.children + 1});
  }
  return false;
}

}  // namespace tribunal::stretching
