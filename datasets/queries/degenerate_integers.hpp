// Exactly degenerate queries with integer coordinates, which several families start from.
#pragma once

#include "datasets/random.hpp"
#include "predicates/point.hpp"
#include "predicates/predicate.hpp"

#include <span>

namespace tribunal::queries {

/// Distinct points with integer coordinates in (0, 2^21), on a line, circle, plane or sphere as the predicate
/// asks; one in-sphere query of eight is on a line or plane instead. Differences are below 2^20. Its exact
/// sign is zero.
void draw_degenerate_integers(Predicate predicate, Random& random, std::span<Point2> points);
void draw_degenerate_integers(Predicate predicate, Random& random, std::span<Point3> points);

}  // namespace tribunal::queries
