// The surfaces that scattered-data methods are tried on.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal {

/// Franke's test functions (1979) over the unit square: two humps and a dip, a cliff, a saddle, a gentle and
/// a steep hill, part of a sphere. Outside the square they are what their formulas say, the sphere 0 beyond
/// its rim. By the C library's functions: last bits may differ between machines.
struct FrankeFunction {
  std::string_view name;  ///< "F1" to "F6"
  double (*value)(const Point2&);
};

const std::array<FrankeFunction, 6>& franke_functions();

/// The function's values at the points.
std::vector<double> sample(const FrankeFunction& function, std::span<const Point2> points);

}  // namespace tribunal
