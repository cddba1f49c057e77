// What algorithms see of the predicates: an interface, bound once to the data, that answers with signs.
#pragma once

#include "predicates/decision.hpp"
#include "predicates/formulas/compare_angle.hpp"
#include "predicates/point.hpp"
#include "predicates/sign.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <variant>

namespace tribunal {

/// Planar predicates over a fixed point set. Thread-safe: queries share no mutable state.
class Kernel2 {
 public:
  Kernel2() = default;
  Kernel2(const Kernel2&) = delete;
  Kernel2& operator=(const Kernel2&) = delete;
  virtual ~Kernel2() = default;

  /// Positive when a, b, c turn counter-clockwise, zero when they are collinear.
  Sign orient2d(Point2 a, Point2 b, Point2 c) const { return decide_orient2d(a, b, c).sign; }

  /// Positive when d is strictly inside the circle of the counter-clockwise triple a, b, c; zero on it.
  Sign incircle(Point2 a, Point2 b, Point2 c, Point2 d) const { return decide_incircle(a, b, c, d).sign; }

  /// Positive when the segment ab is longer than cd, zero when they are equally long.
  Sign compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const {
    return decide_compare_length(a, b, c, d).sign;
  }

  /// Positive when the angle p is larger than q. Both lie in [0, pi]; no leg has length zero.
  Sign compare_angle(const Angle<2>& p, const Angle<2>& q) const { return decide_compare_angle(p, q).sign; }

  virtual Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const = 0;
  virtual Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const = 0;
  virtual Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const = 0;
  virtual Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const = 0;

  /// Whether a constructed point (one not bound) may be asked about.
  virtual bool admits(Point2 p) const = 0;
};

/// Spatial predicates over a fixed point set.
class Kernel3 {
 public:
  Kernel3() = default;
  Kernel3(const Kernel3&) = delete;
  Kernel3& operator=(const Kernel3&) = delete;
  virtual ~Kernel3() = default;

  /// sign det(b-a, c-a, d-a).
  Sign orient3d(Point3 a, Point3 b, Point3 c, Point3 d) const { return decide_orient3d(a, b, c, d).sign; }

  /// Positive when e is strictly inside the sphere of four points with orient3d > 0; zero on it.
  Sign insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) const {
    return decide_insphere(a, b, c, d, e).sign;
  }

  virtual Decision decide_orient3d(Point3 a, Point3 b, Point3 c, Point3 d) const = 0;
  virtual Decision decide_insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) const = 0;

  virtual bool admits(Point3 p) const = 0;
};

/// Why a backend will not answer about these points: the first one outside its domain.
struct Refusal {
  std::size_t point;   ///< index into the points given to bind
  std::string reason;  ///< e.g. "x = 16384 leaves a box wider than 2^14 - 1"
};

template <class Bound>
using Binding = std::variant<Bound, Refusal>;
using Kernel2Binding = Binding<std::unique_ptr<const Kernel2>>;
using Kernel3Binding = Binding<std::unique_ptr<const Kernel3>>;

}  // namespace tribunal
