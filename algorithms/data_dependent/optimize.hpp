// Data-dependent triangulation as users set it up.
#pragma once

#include "algorithms/data_dependent/searches.hpp"
#include "algorithms/parameter.hpp"

#include <span>
#include <vector>

namespace tribunal {

/// The data of the points that the settings choose: their own `values`, or a function's. Abandons
/// (refused_input) where the points have none.
std::vector<double> chosen_data(std::span<const Point2> points, std::span<const double> values,
                                const Settings& settings);

/// Flips the mesh as the settings say, data being given by point. Settings are of data_dependent_parameters
/// (parameters.hpp), and accepted.
FlipCounts flip_for_data(const Sites& sites, EdgeMesh& mesh, std::span<const double> data,
                         const Settings& settings);

/// The measure that the settings choose, over these data.
Roughness chosen_roughness(std::span<const Point2> points, std::span<const double> data,
                           const Settings& settings);

}  // namespace tribunal
