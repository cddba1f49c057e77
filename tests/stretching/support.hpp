// Domains of a few lines, and the kernel over their points.
#pragma once

#include "algorithms/refinement/domain_mesh.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"

#include <numeric>

namespace tribunal::stretching::test {

/// A graph of a dataset or by hand, and what refers to it.
struct Sample {
  DatasetGraph data;
  std::unique_ptr<const Kernel2> kernel;
  std::vector<Index> order;

  explicit Sample(DatasetGraph graph) : data(std::move(graph)), order(data.points.size()) {
    kernel = std::move(std::get<0>(find_backend("filtered")->bind2(data.points)));
    std::iota(order.begin(), order.end(), Index{0});
  }
  Graph graph() const { return {data.points, data.segments, data.holes, Domain::carved}; }
  constrained::GraphMesh mesh() const { return refinement::build_domain_mesh(graph(), order, *kernel); }
};

/// A closed polygon.
inline DatasetGraph polygon(std::vector<Point2> points) {
  DatasetGraph graph{std::move(points), {}, {}};
  const auto size = static_cast<std::uint32_t>(graph.points.size());
  for (std::uint32_t i = 0; i < size; ++i) graph.segments.push_back({i, (i + 1) % size});
  return graph;
}

}  // namespace tribunal::stretching::test
