// What makes a triangle badly shaped, and where its circumcentre is.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <string>

namespace tribunal::refinement {

using Corners = std::array<Point2, 3>;

/// A bound on the smallest angle of triangles, as the square of its sine. Of a triangle that meets the bound
/// with equality the circumradius is 1 / (2 sine) times the shortest edge.
struct AngleBound {
  double sine_squared;

  /// At least `angle` degrees, from 0 to 60.
  static AngleBound degrees(double angle);
  /// At most `ratio` of circumradius to shortest edge, 1/sqrt(3) or more.
  static AngleBound radius_to_edge(double ratio);
};

/// Whether the smallest angle of the triangle, which is counter-clockwise, is less than the bound: exact. A
/// filter of floating-point numbers decides nearly always, rational numbers the rest.
bool is_sharper(const Corners& triangle, AngleBound bound);

/// "x = 0.5, y = 1e-09", for messages.
std::string text_of(Point2 p);

/// Rounded, whatever the coordinates: no square leaves the range of doubles.
double distance(Point2 a, Point2 b);

/// The lengths of the edges opposite the corners, rounded.
std::array<double, 3> edge_lengths(const Corners& triangle);

/// The circumradius, rounded; infinite where the area is too small for doubles.
double circumradius(const Corners& triangle);

/// Zero for triangles of any usual size. For others, whose products of lengths would leave the range of
/// doubles, an exponent of two to divide by first.
int excess_exponent(const Corners& triangle);
/// p times 2^exponent.
Point2 scaled(Point2 p, int exponent);
Corners scaled(const Corners& triangle, int exponent);

/// The circumcentre, rounded; a point far away in its direction where the area is too small for doubles.
Point2 circumcentre(const Corners& triangle);

/// The smallest and the largest angle in degrees, rounded.
std::array<double, 2> extreme_angles(const Corners& triangle);

}  // namespace tribunal::refinement
