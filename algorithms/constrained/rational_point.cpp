#include "algorithms/constrained/rational_point.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
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

Point2 nearest(const RationalPoint& p) { return {{nearest_double(p.x), nearest_double(p.y)}}; }

}  // namespace tribunal
