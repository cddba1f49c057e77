// What tests of flips share: points bound to a backend, meshes checked, integer angles.
#pragma once

#include "algorithms/flips/lawson.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tribunal::flips {

/// Distinct points with a kernel. Where the backend refuses them or they are all collinear, `usable` is
/// false.
class Plane {
 public:
  explicit Plane(std::vector<Point2> given, std::string_view backend = "filtered") : points(distinct(given)) {
    auto bound = find_backend(backend)->bind2(points);
    if (auto* kernel = std::get_if<0>(&bound)) kernel_ = std::move(*kernel);
    for (Index v = 0; v < points.size(); ++v) vertices.push_back(v);
    if (kernel_ == nullptr) return;
    for (std::size_t i = 2; i < points.size() && !usable; ++i)
      usable = kernel_->orient2d(points[0], points[1], points[i]) != Sign::zero;
  }
  Sites sites() const { return {points, *kernel_}; }

  std::vector<Point2> points;
  std::vector<Index> vertices;
  bool usable = false;

 private:
  static std::vector<Point2> distinct(const std::vector<Point2>& given) {
    std::vector<Point2> kept;
    for (const Point2& p : given)
      if (std::find(kept.begin(), kept.end(), p) == kept.end()) kept.push_back(p);
    return kept;
  }
  std::unique_ptr<const Kernel2> kernel_;
};

/// Empty when the triangles are a triangulation, or a Delaunay one, of the points; else the first fault.
inline std::string fault_of(const std::vector<Point2>& points, const std::vector<Triangle>& triangles,
                            verify::Kind kind = verify::Kind::triangulation) {
  const auto verdict = verify::verify_planar(points, {triangles}, {.kind = kind});
  if (verdict.valid()) return {};
  return std::string(verify::to_string(verdict.faults[0].kind)) + ": " + verdict.faults[0].detail;
}

/// All points of the mask on a 3 x 3 grid, mixed up.
inline std::vector<Point2> small_lattice_set(int mask) {
  std::vector<Point2> points;
  for (int i = 0; i < 9; ++i)
    if (mask >> i & 1) points.push_back({double(i * 5 % 9 % 3), double(i * 5 % 9 / 3)});
  return points;
}

/// The cosine of an angle as an exact fraction, of points with integer coordinates below 2^10.
struct IntegerAngle {
  std::int64_t dot = 0, legs = 1;

  IntegerAngle(Point2 a, Point2 apex, Point2 b) {
    const auto ux = integer(a[0] - apex[0]), uy = integer(a[1] - apex[1]);
    const auto vx = integer(b[0] - apex[0]), vy = integer(b[1] - apex[1]);
    dot = ux * vx + uy * vy;
    legs = (ux * ux + uy * uy) * (vx * vx + vy * vy);
  }
  /// By cosine, which falls.
  friend bool operator<(const IntegerAngle& p, const IntegerAngle& q) {
    const auto square = [](const IntegerAngle& a) { return Wide{a.dot} * (a.dot < 0 ? -a.dot : a.dot); };
    return square(p) * q.legs > square(q) * p.legs;
  }
  friend bool operator==(const IntegerAngle& p, const IntegerAngle& q) { return !(p < q) && !(q < p); }

 private:
  __extension__ using Wide = __int128;
  static std::int64_t integer(double x) { return static_cast<std::int64_t>(x); }
};

/// Of some triangles, ascending.
inline std::vector<IntegerAngle> angles_of(const std::vector<Point2>& p,
                                           const std::vector<Triangle>& triangles) {
  std::vector<IntegerAngle> angles;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) angles.emplace_back(p[t[i]], p[t[(i + 1) % 3]], p[t[(i + 2) % 3]]);
  std::sort(angles.begin(), angles.end());
  return angles;
}

inline std::vector<Point2> integer_points(std::size_t n, std::uint64_t size, Random& random) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({static_cast<double>(random.below(size)), static_cast<double>(random.below(size))});
  return points;
}

}  // namespace tribunal::flips
