// What a cell's task is given: points, an insertion order, a kernel.
#pragma once

#include "algorithms/triangulation.hpp"
#include "bench/row.hpp"
#include "datasets/dataset.hpp"
#include "predicates/kernel.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::bench {

/// The cell's dataset, quantised if it says so. Throws BadInput when there is no such dataset.
std::vector<Point2> cell_points(const Cell& cell);

/// The same with segments. Throws BadInput also when the dataset has none.
DatasetGraph cell_graph(const Cell& cell);

/// The points without repetitions, each at its first place. O(n log n).
std::vector<Point2> distinct_points(std::span<const Point2> points);

/// The insertion order that the cell names, drawn with `seed`. Throws BadInput when there is no such order.
std::vector<Index> cell_order(std::span<const Point2> points, const Cell& cell, std::uint64_t seed);

/// The cell's backend bound to the points, or why it will not. Throws BadInput when there is no such backend.
Kernel2Binding cell_kernel(std::span<const Point2> points, const Cell& cell);

/// The same in space; a backend without spatial predicates refuses.
Kernel3Binding cell_kernel3(std::span<const Point3> points, const Cell& cell);

/// "point 17: x = 16384 ...": a refusal as a row's reason.
std::string describe(const Refusal& refusal);

}  // namespace tribunal::bench
