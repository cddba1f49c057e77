// Families of queries to hold laws against: each is a list of D + 2 points, the first D + 1 of which are an
// orientation query, and all an in-sphere query.
#pragma once

#include "datasets/random.hpp"
#include "predicates/point.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace tribunal::laws {

template <int D>
using Case = std::array<Point<D>, D + 2>;

template <int D>
struct Family {
  std::string name;
  std::vector<Case<D>> cases;
  /// Integers so small that plain double precision computes every intermediate value exactly.
  bool exact_in_double = false;

  std::vector<Point<D>> points() const {
    std::vector<Point<D>> all;
    for (const auto& c : cases) all.insert(all.end(), c.begin(), c.end());
    return all;
  }
};

/// `count` cases whose points `draw()` makes one at a time.
template <int D, class Draw>
std::vector<Case<D>> draw_cases(int count, Draw draw) {
  std::vector<Case<D>> cases(static_cast<std::size_t>(count));
  for (auto& points : cases)
    for (auto& p : points) p = draw();
  return cases;
}

template <int D, class Draw>
Point<D> draw_point(Draw draw) {
  Point<D> p{};
  for (double& c : p.coordinate) c = draw();
  return p;
}

/// Coordinates in {0, ..., size - 1} * unit + offset, without rounding for the values used here.
template <int D>
std::vector<Case<D>> integer_cases(int count, std::uint64_t size, double unit, double offset,
                                   Random& random) {
  return draw_cases<D>(count, [&] {
    return draw_point<D>([&] { return offset + unit * static_cast<double>(random.below(size)); });
  });
}

/// All integer points at the distance sqrt(square) from the origin.
template <int D>
std::vector<Point<D>> integer_sphere(int square) {
  std::vector<Point<D>> sphere;
  const int radius = static_cast<int>(std::sqrt(square)) + 1;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y) {
      const int rest = square - x * x - y * y;
      if constexpr (D == 2) {
        if (rest == 0) sphere.push_back({{double(x), double(y)}});
      } else {
        for (int z = -radius; z <= radius; ++z)
          if (z * z == rest) sphere.push_back({{double(x), double(y), double(z)}});
      }
    }
  return sphere;
}

/// Points of one integer circle or sphere, so that in-sphere is zero unless the last is moved a little.
template <int D>
std::vector<Case<D>> cospherical_cases(int count, int square, Random& random) {
  const auto sphere = integer_sphere<D>(square);
  auto cases = draw_cases<D>(count, [&] { return sphere[random.below(sphere.size())]; });
  for (auto& points : cases)
    if (random.below(4) == 0) points[D + 1][0] += 1;
  return cases;
}

/// Points on a line (in space: on a plane), rounded to doubles and moved by a few multiples of `step`.
template <int D>
std::vector<Case<D>> near_flat_cases(int count, double step, Random& random) {
  return draw_cases<D>(count, [&] {
    const double t = random.unit(), s = random.unit();
    Point<D> p{};
    for (int axis = 0; axis < D; ++axis) {
      p[axis] = 0.1 + t * (axis + 1) / 4 + (D == 3 ? s * (3 - axis) / 8 : 0);
      p[axis] += static_cast<double>(random.below(3)) * step;
    }
    return p;
  });
}

/// Points rounded from the unit sphere.
template <int D>
std::vector<Case<D>> near_sphere_cases(int count, Random& random) {
  return draw_cases<D>(count, [&] {
    Point<D> p = draw_point<D>([&] { return 2 * random.unit() - 1; });
    double length = 0;
    for (const double c : p.coordinate) length += c * c;
    for (double& c : p.coordinate) c /= std::sqrt(length);
    return p;
  });
}

/// The same cases in integers: each coordinate times 2^bits, rounded down.
template <int D>
std::vector<Case<D>> quantised(std::vector<Case<D>> cases, int bits) {
  for (auto& points : cases)
    for (auto& p : points)
      for (double& c : p.coordinate) c = std::floor(std::ldexp(c, bits));
  return cases;
}

/// Signed coordinates with binary exponents uniform in [lowest, highest], often equal so that cancellation
/// happens.
template <int D>
std::vector<Case<D>> exponent_cases(int count, int lowest, int highest, Random& random) {
  const auto range = static_cast<std::uint64_t>(highest - lowest + 1);
  std::vector<double> recent(8, 0.0);
  return draw_cases<D>(count, [&] {
    return draw_point<D>([&] {
      double& slot = recent[random.below(recent.size())];
      if (random.below(2) == 0) return slot;
      const double mantissa = (1 + random.unit()) * (random.below(2) == 0 ? 1 : -1);
      const int exponent = lowest + static_cast<int>(random.below(range));
      return slot = std::ldexp(mantissa, exponent);
    });
  });
}

/// Signed zeros, the ends of the ranges of subnormal and of normal doubles, and powers of two with their
/// neighbours.
template <int D>
std::vector<Case<D>> special_cases(int count, Random& random) {
  std::vector<double> values{
      0.0, 0x1p-1074, 0x1p-1073, 0x0.fffffffffffffp-1022, 0x1p-1022, 0x1.fffffffffffffp1023};
  for (const int exponent : {-1000, -511, -1, 0, 1, 52, 53, 511, 1022})
    for (const double neighbour : {0x1.fffffffffffffp-1, 1.0, 0x1.0000000000001p0})
      values.push_back(std::ldexp(neighbour, exponent));
  return draw_cases<D>(count, [&] {
    const double scarce = values[random.below(values.size())];  // so that points have coordinates in common
    return draw_point<D>([&] {
      const double value = random.below(2) == 0 ? scarce : values[random.below(values.size())];
      return random.below(2) == 0 ? value : -value;
    });
  });
}

/// Integers below 2^14: the domain that all backends share.
template <int D>
Family<D> shared_domain(int count, std::uint64_t seed) {
  Random random(seed);
  return {"integers of 14 bits", integer_cases<D>(count, 1 << 14, 1, 0, random)};
}

template <int D>
std::vector<Family<D>> families() {
  Random random(20240 + D);
  std::vector<Family<D>> all;
  const auto add = [&](std::string name, std::vector<Case<D>> cases, bool exact_in_double = false) {
    all.push_back({std::move(name), std::move(cases), exact_in_double});
  };
  add("grid of 3", integer_cases<D>(4000, 3, 1, 0, random), true);
  add("integers of 8 bits", integer_cases<D>(2000, 1 << 8, 1, -100, random), true);
  add("integers of 14 bits", integer_cases<D>(2000, 1 << 14, 1, 0, random));
  add("14 bits far away", integer_cases<D>(1000, 1 << 14, 1, 0x1p50, random));
  add("cospherical integers", cospherical_cases<D>(4000, D == 2 ? 1105 * 1105 : 21 * 21, random));
  add("integers of 28 bits", integer_cases<D>(1000, 1 << 28, 1, 0, random));
  add("integers of 53 bits", integer_cases<D>(1000, std::uint64_t{1} << 53, 1, 0, random));
  add("fine lattice", integer_cases<D>(1000, 5, 0x1p-1020, 0, random));
  add("coarse lattice", integer_cases<D>(1000, 5, 0x1p1000, 0, random));
  add("uniform", draw_cases<D>(2000, [&] { return draw_point<D>([&] { return random.unit(); }); }));
  add("near flat", near_flat_cases<D>(4000, 0x1p-54, random));
  add("near sphere", near_sphere_cases<D>(4000, random));
  for (const int bits : {13, 24, 28, 36, 50, 53}) {  // of the differences
    const std::string suffix = " in " + std::to_string(bits) + " bits";
    const double unit = std::ldexp(1.0, 1 - bits);
    add("near flat" + suffix, quantised<D>(near_flat_cases<D>(1000, unit, random), bits - 1));
    add("near sphere" + suffix, quantised<D>(near_sphere_cases<D>(1000, random), bits - 1));
  }
  add("mixed exponents", exponent_cases<D>(2000, -30, 30, random));
  add("all exponents", exponent_cases<D>(1000, -1074, 1023, random));
  for (int degree = 2; degree <= D + 2; ++degree)  // products of that many coordinates straddle the threshold
    add("underflow at degree " + std::to_string(degree),
        exponent_cases<D>(2000, -1100 / degree, -980 / degree, random));
  add("subnormal", exponent_cases<D>(2000, -1074, -1020, random));
  add("near overflow", exponent_cases<D>(2000, 1000, 1023, random));
  add("special values", special_cases<D>(4000, random));
  return all;
}

}  // namespace tribunal::laws
