#include "algorithms/refinement/adaptive.hpp"

#include "algorithms/constrained/graph_mesh.hpp"

#include <algorithm>

namespace tribunal::refinement {
namespace {

double largest_measure(SolutionMeasure& measure, const SteinerMesh& mesh) {
  double largest = 0;
  for (Index t = 0; t < mesh.triangles().triangles(); ++t)
    if (mesh.in_domain(t)) largest = std::max(largest, measure.of(mesh, t));
  return largest;
}

}  // namespace

Adapted refine_by_solution(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                           Field& field, const AdaptiveOptions& options) {
  Adapted adapted;
  constrained::report_refusals(adapted.refinement.report, [&] {
    SteinerMesh mesh(graph, order, kernel);
    SolutionMeasure measure(field, options.tolerance);
    adapted.before = largest_measure(measure, mesh);
    ChewOptions chew = options.chew;
    chew.measure = &measure;
    adapted.refinement.counts = refine_mesh(mesh, chew);
    adapted.refinement.mesh = mesh.result();
    adapted.after = largest_measure(measure, mesh);
  });
  return adapted;
}

}  // namespace tribunal::refinement
