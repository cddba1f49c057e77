// From the edges of a triangulation to its triangles.
#pragma once

#include "algorithms/greedy/problem.hpp"

#include <vector>

namespace tribunal {

/// The triangles between the edges of a complete triangulation of the problem's domain, counter-clockwise,
/// each beginning with its least index. O(m log m).
std::vector<Triangle> faces_between(const GreedyProblem& problem, const std::vector<Edge>& edges);

}  // namespace tribunal
