#include "algorithms/mesh/assemble.hpp"

#include "algorithms/abandon.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace tribunal {
namespace {

[[noreturn]] void refuse() {
  throw Abandon(Outcome::inconsistent_predicate, "the triangles to start from are no triangulation");
}

/// Half-edges in an order that brings twins together.
std::vector<HalfEdge> sorted_by_ends(const PlanarMesh& mesh) {
  const auto ends = [&](HalfEdge h) {
    const auto [least, most] = undirected(mesh.from(h), mesh.to(h));
    return std::uint64_t{least} << 32 | most;
  };
  std::vector<HalfEdge> sides(3 * std::size_t{mesh.triangles()});
  for (HalfEdge h = 0; h < sides.size(); ++h) sides[h] = h;
  std::sort(sides.begin(), sides.end(),
            [&](HalfEdge g, HalfEdge h) { return ends(g) != ends(h) ? ends(g) < ends(h) : g < h; });
  return sides;
}

/// Glues twins; returns the half-edges without one, each the only one with its ends.
std::vector<HalfEdge> glue_twins(PlanarMesh& mesh) {
  std::vector<HalfEdge> hull;
  const std::vector<HalfEdge> sides = sorted_by_ends(mesh);
  const auto are_twins = [&](HalfEdge g, HalfEdge h) {
    return mesh.from(g) == mesh.to(h) && mesh.to(g) == mesh.from(h);
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i + 1 < sides.size() && are_twins(sides[i], sides[i + 1])) {
      mesh.glue(sides[i], sides[i + 1]);
      ++i;
    } else {
      hull.push_back(sides[i]);
    }
  }
  return hull;
}

}  // namespace

PlanarMesh assemble(std::span<const Triangle> triangles) {
  PlanarMesh mesh;
  Index last = 0;
  for (const Triangle& t : triangles) {
    mesh.add(t[0], t[1], t[2]);
    last = std::max({last, t[0], t[1], t[2]});
  }
  const std::vector<HalfEdge> hull = glue_twins(mesh);
  std::vector<Index> ghost_from(std::size_t{last} + 1, PlanarMesh::none);  // by where its hull edge starts
  for (const HalfEdge h : hull) {
    const Index ghost = mesh.add(infinite, mesh.to(h), mesh.from(h));
    mesh.glue(h, 3 * ghost);
    if (std::exchange(ghost_from[mesh.from(h)], ghost) != PlanarMesh::none) refuse();
  }
  for (const HalfEdge h : hull) {
    const Index ghost = ghost_from[mesh.from(h)], following = ghost_from[mesh.to(h)];
    if (following == PlanarMesh::none) refuse();
    mesh.glue(3 * ghost + 2, 3 * following + 1);
  }
  return mesh;
}

}  // namespace tribunal
