// Constrained Delaunay triangulation (Lee and Lin 1986, Chew 1989). Of sites alone, as every listed algorithm
// gets them, it is Green and Sibson's insertion with a walk from site to site; segments come through
// triangulate_graph.
#include "algorithms/constrained/mesh.hpp"
#include "algorithms/constrained/parameters.hpp"
#include "algorithms/insertion/collect.hpp"
#include "algorithms/planar/listed.hpp"

namespace tribunal {
namespace {

Triangulation run(const PlanarProblem& problem) {
  const auto site = [&](std::size_t i) { return problem.points[problem.sites[i]]; };
  constrained::Mesh mesh(problem.kernel, site(0), site(1), site(2));
  mesh.reserve(problem.sites.size());
  for (std::size_t i = 3; i < problem.sites.size(); ++i) mesh.insert(site(i));

  Triangulation result;
  result.counters = mesh.counters();
  for (Index t = 0; t < mesh.triangles().triangles(); ++t) {
    Triangle named = mesh.triangles().triangle(t);
    for (Index& vertex : named)
      if (vertex != infinite) vertex = problem.sites[vertex];
    collect(named, result);
  }
  return result;
}

}  // namespace

constinit const PlanarAlgorithm constrained_algorithm{
    .about = {.name = "constrained",
              .dimension = 2,
              .cites = "Lee, Lin 1986; Chew 1989; Sloan 1993; Anglada 1997",
              .summary = "constrained Delaunay of points and segments: insertion by walking, segments by "
                         "cavities or swaps"},
    .parameters = constrained::parameters,
    .order = "brio",  // it walks from site to site
    .run = run,
};

}  // namespace tribunal
