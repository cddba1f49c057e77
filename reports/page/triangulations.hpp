// Which rows are runs of a triangulation algorithm.
#pragma once

#include "bench/row.hpp"

#include <span>
#include <vector>

namespace tribunal::reports {

/// The rows of tasks that triangulated something in some row, the failed ones of such tasks included;
/// experiments never report a number of triangles.
std::vector<const bench::Row*> triangulations(std::span<const bench::Row> rows);

}  // namespace tribunal::reports
