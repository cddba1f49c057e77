// The filter of a box over several queries in one vector register; compiled once for each instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

// A translation unit compiled for AVX-512 must not define any function that others might be linked with. So
// what stands here belongs to a namespace named after the instruction set, and includes nothing but formulas.

namespace tribunal {

/// One instruction set's way to decide queries by a threshold: writes the sign of each of the first `decided`
/// queries, or zero where the determinant is within the threshold, and returns that number, the largest
/// multiple of the register's lanes in `count`. columns[k * dimension + axis] is the column of that
/// coordinate of the k-th point.
struct LaneFilters {
  using Filter = std::size_t (*)(const double* const* columns, double threshold, std::int8_t* signs,
                                 std::size_t count);
  Filter orient2d, incircle, orient3d, insphere;
};

namespace baseline {
extern const LaneFilters lane_filters;
}
namespace avx2 {
extern const LaneFilters lane_filters;
}
namespace avx512 {
extern const LaneFilters lane_filters;
}

}  // namespace tribunal
