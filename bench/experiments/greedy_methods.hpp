// The three ways to the greedy triangulation, asked alike.
#pragma once

#include "algorithms/greedy/accepted_list.hpp"
#include "algorithms/greedy/faces.hpp"
#include "algorithms/greedy/from_delaunay.hpp"
#include "algorithms/greedy/stars.hpp"
#include "algorithms/list.hpp"
#include "algorithms/mesh/canonical.hpp"

#include <array>
#include <utility>
#include <vector>

namespace tribunal::bench {

struct GreedyAnswer {
  GreedyEdges found;
  std::vector<Triangle> triangles;  ///< canonical
  friend bool operator==(const GreedyAnswer& a, const GreedyAnswer& b) {
    return a.found.edges == b.found.edges && a.triangles == b.triangles;
  }
};

inline GreedyAnswer answer_from_pool(const GreedyProblem& problem, AcceptedEdges& accepted) {
  GreedyEdges found = triangulate_from_pool(problem, accepted);
  std::vector<Triangle> triangles = canonical(faces_between(problem, found.edges));
  return {std::move(found), std::move(triangles)};
}

/// By a list, by stars, and from the Delaunay triangulation, in this order. Throws Abandon.
inline std::array<GreedyAnswer, 3> greedy_answers(const GreedyProblem& problem) {
  AcceptedList list(problem.planar, false);
  Stars stars(problem.planar);
  const Triangulation delaunay = find_planar_algorithm("green-sibson")->run(problem.planar);
  GreedyMesh mesh = triangulate_from_delaunay(problem, delaunay.triangles);
  return {answer_from_pool(problem, list), answer_from_pool(problem, stars),
          GreedyAnswer{std::move(mesh.found), canonical(mesh.triangles)}};
}

}  // namespace tribunal::bench
