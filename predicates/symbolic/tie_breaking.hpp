// Kernels that answer in-sphere ties symbolically: what `+sos` after a backend's name means.
#pragma once

#include "predicates/kernel.hpp"
#include "predicates/symbolic/lift_perturbation.hpp"

#include <memory>
#include <utility>

namespace tribunal {

// Which ties does `+sos` break? Those of the in-sphere test, by default and always: the Delaunay
// triangulation of points with cocircular quadruples then is unique, the same for every algorithm, every
// order of insertion and every exact backend, and each of its cells has volume. Ties of orientation are left
// as they are, for they are facts that algorithms need: that a site lies on an edge, that a point is on the
// hull, that all points are collinear. With them broken, three collinear points would span a triangle without
// area. So are ties of lengths and angles: equal is what they are. Who wants that asks
// simulation_of_simplicity.hpp.

/// Passes queries on to an exact kernel, which it owns, and breaks the ties of incircle.
class TieBreakingKernel2 final : public Kernel2 {
 public:
  explicit TieBreakingKernel2(std::unique_ptr<const Kernel2> exact) : exact_(std::move(exact)) {}
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    return exact_->decide_orient2d(a, b, c);
  }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    const Decision decision = exact_->decide_incircle(a, b, c, d);
    if (decision.sign != Sign::zero) [[likely]]
      return decision;
    return break_in_sphere_tie<2>({a, b, c, d},
                                  [&](const auto& p) { return exact_->orient2d(p[0], p[1], p[2]); });
  }
  Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return exact_->decide_compare_length(a, b, c, d);
  }
  Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const override {
    return exact_->decide_compare_angle(p, q);
  }
  bool admits(Point2 p) const override { return exact_->admits(p); }

 private:
  std::unique_ptr<const Kernel2> exact_;
};

/// The same in space.
class TieBreakingKernel3 final : public Kernel3 {
 public:
  explicit TieBreakingKernel3(std::unique_ptr<const Kernel3> exact) : exact_(std::move(exact)) {}
  Decision decide_orient3d(Point3 a, Point3 b, Point3 c, Point3 d) const override {
    return exact_->decide_orient3d(a, b, c, d);
  }
  Decision decide_insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) const override {
    const Decision decision = exact_->decide_insphere(a, b, c, d, e);
    if (decision.sign != Sign::zero) [[likely]]
      return decision;
    return break_in_sphere_tie<3>({a, b, c, d, e},
                                  [&](const auto& p) { return exact_->orient3d(p[0], p[1], p[2], p[3]); });
  }
  bool admits(Point3 p) const override { return exact_->admits(p); }

 private:
  std::unique_ptr<const Kernel3> exact_;
};

}  // namespace tribunal
