// How far to the right a circle reaches, certified.
#pragma once

#include "predicates/point.hpp"

namespace tribunal {

/// An upper bound of the x coordinates on the circle through a, b, c; infinity when rounding leaves none to
/// be certain of. It decides only when work may stop, never a sign.
double right_extent(const Point2& a, const Point2& b, const Point2& c);

}  // namespace tribunal
