#include "algorithms/constrained/rational_point.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace tribunal {
namespace {

double nearest_double(const mpq_class& value) {
  // GMP rounds towards zero; the nearest double is that one or the next one outwards.
  const double inner = value.get_d();
  const double outer = std::nextafter(inner, sgn(value) < 0 ? -std::numeric_limits<double>::infinity()
                                                            : std::numeric_limits<double>::infinity());
  if (std::isinf(outer)) return inner;
  const mpq_class to_inner = abs(value - mpq_class(inner)), to_outer = abs(mpq_class(outer) - value);
  if (to_inner != to_outer) return to_inner < to_outer ? inner : outer;
  return (std::bit_cast<std::uint64_t>(inner) & 1) == 0 ? inner : outer;
}

}  // namespace

RationalPoint intersection(Point2 a, Point2 b, Point2 c, Point2 d) {
  const RationalPoint p = rational(a), q = rational(b), r = rational(c), s = rational(d);
  const mpq_class ux = q.x - p.x, uy = q.y - p.y, vx = s.x - r.x, vy = s.y - r.y;
  const mpq_class t = ((r.x - p.x) * vy - (r.y - p.y) * vx) / (ux * vy - uy * vx);
  return {p.x + t * ux, p.y + t * uy};
}

CoarseNumbers::CoarseNumbers(std::span<const Point2> points, int dropped, int exponent) : dropped_(dropped) {
  double largest = 0;
  for (const std::size_t axis : {0, 1}) {
    for (const Point2& p : points) kept_[axis].push_back(p[axis]);
    std::ranges::sort(kept_[axis]);
    largest = std::max({largest, -kept_[axis].front(), kept_[axis].back()});
  }
  const int last_place = (largest > 0 ? std::ilogb(largest) : 0) - (std::numeric_limits<double>::digits - 1);
  finest_ = std::ldexp(1.0, std::clamp(last_place + exponent, -1074, 1000));
}

Point2 CoarseNumbers::nearest(const RationalPoint& p) const {
  return {{nearest_of(p.x, kept_[0]), nearest_of(p.y, kept_[1])}};
}

/// The multiple of the unit below the value, the one above it, and the nearest ones that are kept: whichever
/// is nearest. All of them are doubles, or beyond their range.
double CoarseNumbers::nearest_of(const mpq_class& value, const std::vector<double>& kept) const {
  const double towards_zero = value.get_d();
  double unit = finest_;
  if (towards_zero != 0)
    unit = std::max(unit, std::ldexp(1.0, std::ilogb(towards_zero) -
                                              (std::numeric_limits<double>::digits - 1) + dropped_));
  const mpq_class steps = value / mpq_class(unit);
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  const double below = floor.get_d() * unit;
  if (floor == steps) return below;
  std::vector<double> candidates{below, below + unit};
  const auto after = std::lower_bound(kept.begin(), kept.end(), value,
                                      [](double x, const mpq_class& bound) { return mpq_class(x) < bound; });
  if (after != kept.end()) candidates.push_back(*after);
  if (after != kept.begin()) candidates.push_back(*std::prev(after));
  std::erase_if(candidates, [](double candidate) { return !std::isfinite(candidate); });
  std::ranges::sort(candidates);
  return *std::ranges::min_element(
      candidates, {}, [&](double candidate) { return mpq_class(abs(mpq_class(candidate) - value)); });
}

Point2 nearest(const RationalPoint& p) { return {{nearest_double(p.x), nearest_double(p.y)}}; }

}  // namespace tribunal
