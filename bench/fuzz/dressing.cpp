#include "bench/fuzz/dressing.hpp"

#include "bench/fuzz/ulps.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::bench::fuzz {
namespace {

/// Uniform on {low, ..., high}.
int between(Random& random, int low, int high) {
  return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

double& any_number(Case& asked, Random& random) { return asked.numbers()[random.below(asked.size())]; }

/// An exponent e such that coordinates of `bits` bits times 2^e are: moderate; subnormal; such that products
/// of the predicate's degree underflow or overflow; or next to overflow themselves.
int scale_exponent(Predicate predicate, int bits, Random& random) {
  const bool orientation = predicate == Predicate::orient2d || predicate == Predicate::orient3d;
  const int degree = dimension_of(predicate) + (orientation ? 0 : 2);
  switch (random.below(5)) {
    case 0:
      return between(random, -100, 100);
    case 1:
      return between(random, -1074, -1020);
    case 2:
      return between(random, -1100, -960) / degree - bits;
    case 3:
      return between(random, 960, 1030) / degree - bits;
    default:
      return between(random, 1018, 1024) - bits;
  }
}

}  // namespace

Dressing::Dressing(Predicate predicate, int bits, Random& random)
    : fabric_(static_cast<Fabric>(random.below(fabric_names.size()))) {
  switch (fabric_) {
    case Fabric::scaled:
      exponents_.fill(scale_exponent(predicate, bits, random));
      break;
    case Fabric::stretched: {
      const int most = std::array{30, 480, 960}[random.below(3)];
      for (int& exponent : exponents_) exponent = between(random, -most, most - bits);
      // Differences on both sides of the smallest normal number that meet large factors: what flushing
      // subnormal numbers to zero would spoil.
      if (most == 960) exponents_[random.below(2)] = std::max(-1074, -1026 - bits + between(random, 0, 8));
      break;
    }
    case Fabric::divided:
      divisor_ = std::array{3.0, 7.0, 10.0}[random.below(3)];
      break;
    case Fabric::turned: {
      // (1 - t^2)^2 + (2 t)^2 = (1 + t^2)^2: a rotation without trigonometric functions, the same everywhere.
      const double t = random.unit();
      cosine_ = (1 - t * t) / (1 + t * t);
      sine_ = 2 * t / (1 + t * t);
      break;
    }
    case Fabric::shifted:
      offset_ = std::ldexp(1.0, bits + between(random, 0, 53));
      break;
    case Fabric::plain:
    case Fabric::nudged:
    case Fabric::ulps:
    case Fabric::mixed:
      break;
  }
}

void Dressing::turn(Case& asked) const {
  for (int i = 0; i < asked.points(); ++i) {
    const auto p = asked.point(i);
    const double x = p[0], y = p[1];
    p[0] = cosine_ * x - sine_ * y;
    p[1] = sine_ * x + cosine_ * y;
  }
}

void Dressing::apply(Case& asked, Random& random) const {
  switch (fabric_) {
    case Fabric::plain:
      return;
    case Fabric::nudged:
      if (random.below(4) != 0) any_number(asked, random) += random.below(2) == 0 ? 1 : -1;
      return;
    case Fabric::ulps:
      for (auto moves = random.below(4); moves > 0; --moves) {
        double& c = any_number(asked, random);
        c = moved_by_ulps(c, between(random, -4, 4));
      }
      return;
    case Fabric::scaled:
    case Fabric::stretched:
      for (std::size_t i = 0; i < asked.size(); ++i) {
        double& c = asked.numbers()[i];
        c = made_finite(std::ldexp(c, exponents_[i % static_cast<std::size_t>(asked.dimension())]));
      }
      return;
    case Fabric::divided:
      for (double& c : asked.numbers()) c /= divisor_;
      return;
    case Fabric::turned:
      turn(asked);
      return;
    case Fabric::shifted:
      for (double& c : asked.numbers()) c += offset_;
      return;
    case Fabric::mixed:
      for (double& c : asked.numbers()) c = std::ldexp(c, between(random, -40, 40));
      return;
  }
}

}  // namespace tribunal::bench::fuzz
