#include "algorithms/greedy/conflict.hpp"

#include <algorithm>
#include <utility>

namespace tribunal {
namespace {

bool boxes_are_apart(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
        std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]))
      return true;
  return false;
}

/// Of two segments that start at `start`: whether one runs along the other.
bool run_along(const Kernel2& kernel, const Point2& start, const Point2& p, const Point2& q) {
  return (start < p) == (start < q) && kernel.orient2d(start, p, q) == Sign::zero;
}

bool on_one_side(Sign s, Sign t) { return s == t && s != Sign::zero; }

}  // namespace

bool segments_conflict(const PlanarProblem& problem, const Edge& e, const Edge& f) {
  for (const Index i : {0, 1})
    for (const Index j : {0, 1})
      if (e[i] == f[j])
        return run_along(problem.kernel, problem.points[e[i]], problem.points[e[1 - i]],
                         problem.points[f[1 - j]]);
  const Point2 &a = problem.points[e[0]], &b = problem.points[e[1]];
  const Point2 &c = problem.points[f[0]], &d = problem.points[f[1]];
  if (boxes_are_apart(a, b, c, d)) return false;
  const Kernel2& kernel = problem.kernel;
  const Sign side_of_c = kernel.orient2d(a, b, c), side_of_d = kernel.orient2d(a, b, d);
  if (on_one_side(side_of_c, side_of_d)) return false;
  // On one line boxes that meet are segments that meet.
  if (side_of_c == Sign::zero && side_of_d == Sign::zero) return true;
  return !on_one_side(kernel.orient2d(c, d, a), kernel.orient2d(c, d, b));
}

}  // namespace tribunal
