#include "bench/input.hpp"

#include "datasets/files/files.hpp"
#include "predicates/backends/list.hpp"

#include <set>
#include <utility>

namespace tribunal::bench {

namespace {
const Dataset& cell_dataset(const Cell& cell) {
  const Dataset* dataset = find_dataset(cell.dataset);
  if (dataset == nullptr) throw BadInput("no dataset is named \"" + cell.dataset + "\"");
  return *dataset;
}
}  // namespace

std::vector<Point2> cell_points(const Cell& cell) {
  std::vector<Point2> points = cell_dataset(cell).generate(cell.n, cell.seed);
  return cell.bits > 0 ? quantise(points, cell.bits) : points;
}

DatasetGraph cell_graph(const Cell& cell) {
  const Dataset& dataset = cell_dataset(cell);
  if (dataset.graph == nullptr) throw BadInput("dataset \"" + cell.dataset + "\" has no segments");
  DatasetGraph graph = dataset.graph(cell.n, cell.seed);
  return cell.bits > 0 ? quantise(std::move(graph), cell.bits) : graph;
}

std::vector<Point2> distinct_points(std::span<const Point2> points) {
  std::set<Point2> seen;
  std::vector<Point2> distinct;
  for (const Point2& p : points)
    if (seen.insert(p).second) distinct.push_back(p);
  return distinct;
}

std::vector<Index> cell_order(std::span<const Point2> points, const Cell& cell, std::uint64_t seed) {
  Order order{};
  if (!parse_order(cell.order, order)) throw BadInput("no order is named \"" + cell.order + "\"");
  return insertion_order(points, order, seed);
}

namespace {
const BackendEntry& cell_backend(const Cell& cell) {
  const BackendEntry* backend = find_backend(cell.backend);
  if (backend == nullptr) throw BadInput("no backend is named \"" + cell.backend + "\"");
  return *backend;
}
}  // namespace

Kernel2Binding cell_kernel(std::span<const Point2> points, const Cell& cell) {
  return cell_backend(cell).bind2(points);
}

Kernel3Binding cell_kernel3(std::span<const Point3> points, const Cell& cell) {
  const BackendEntry& backend = cell_backend(cell);
  if (backend.bind3 == nullptr) return Refusal{0, cell.backend + " has no spatial predicates"};
  return backend.bind3(points);
}

std::string describe(const Refusal& refusal) {
  return "point " + std::to_string(refusal.point) + ": " + refusal.reason;
}

}  // namespace tribunal::bench
