// Closed outlines in the plane, and the domain that they leave of a box.
#pragma once

#include "datasets/dataset.hpp"

#include <vector>

namespace tribunal::shapes {

/// A simple polygon by its vertices, in turn.
using Outline = std::vector<Point2>;

/// A four-digit aerofoil of chord 1 along the x axis (Jacobs, Ward, Pinkerton 1933).
struct FourDigit {
  double camber;     ///< the largest, as a part of the chord
  double camber_at;  ///< where it is
  double thickness;  ///< the largest
  bool blunt;  ///< the trailing edge as published, about 0.2 % thick; else the last coefficient closes it
};

/// Half the thickness at a station, and its slope.
struct HalfThickness {
  double height, slope;
};
HalfThickness half_thickness(const FourDigit& aerofoil, double x);

/// Counter-clockwise from the trailing edge over the upper side: `stations` steps on each side, t^2 (2 - t)
/// for t = 0, 1 / stations, ..., 1 along the chord, so that they are shorter towards the leading edge. A
/// blunt one has a vertex at either end of its base, and at the middle.
Outline outline_of(const FourDigit& aerofoil, std::uint64_t stations);

/// Enlarged by `scale` and turned by the angle of that cosine and sine, both about the origin.
Outline turned(Outline outline, double scale, double cosine, double sine);
Outline moved(Outline outline, double x, double y);

/// The smallest distance between two outlines that do not meet. Runs of sides whose boxes are farther apart
/// are passed over.
double distance(const Outline& a, const Outline& b);

/// Moves `outline` down, or up, until it is `gap` away from `fixed`, to within a millionth; it must not pass
/// by.
Outline closed_up(const Outline& fixed, Outline outline, double gap, bool downwards);

/// The square of that half width about (0.5, 0), `sides` segments to a side.
Outline box_around(double half_width, std::uint64_t sides);

/// Adds the vertices and sides of a closed outline.
void add_loop(DatasetGraph& graph, const Outline& outline);

}  // namespace tribunal::shapes
