#include "algorithms/constrained/removal.hpp"

#include <algorithm>

namespace tribunal::constrained {
namespace {

std::vector<HalfEdge> links(const Mesh& mesh, Index vertex) {
  std::vector<HalfEdge> around;
  const HalfEdge first = mesh.link(vertex);
  HalfEdge h = first;
  do {
    around.push_back(h);
    h = mesh.next_link(h);
  } while (h != first);
  return around;
}

/// Swaps edges off the vertex while any can be. Returns the edges made.
std::vector<Edge> shed(Mesh& mesh, Index vertex, std::size_t degree) {
  std::vector<Edge> made;
  const PlanarMesh& t = mesh.triangles();
  std::size_t kept = 0;  // spokes in a row that cannot be swapped as things stand
  for (HalfEdge h = mesh.link(vertex); degree > 3 && kept < degree;) {
    const HalfEdge spoke = next(h);  // from the end of the link's edge to the vertex
    if (!mesh.swappable(spoke)) {
      ++kept;
      h = mesh.next_link(h);
      continue;
    }
    const Index ahead = t.from(h), behind = t.corner(t.twin(spoke));
    mesh.swap(spoke);
    made.push_back({ahead, behind});
    --degree;
    kept = 0;
    h = mesh.link(vertex);
  }
  return made;
}

/// Three triangles around the vertex become one.
void merge_three(Mesh& mesh, const std::vector<HalfEdge>& around) {
  const PlanarMesh& t = mesh.triangles();
  std::array<HalfEdge, 3> beyond{};
  Triangle corner{};
  for (Index i = 0; i < 3; ++i) {
    beyond[i] = t.twin(around[i]);
    corner[i] = t.from(around[i]);
  }
  const Index place = triangle_of(around[0]);
  mesh.replace(place, corner[0], corner[1], corner[2]);
  for (Index i = 0; i < 3; ++i) mesh.attach(3 * place + (i + 2) % 3, beyond[i]);
  mesh.discard(triangle_of(around[1]));
  mesh.discard(triangle_of(around[2]));
}

/// Four triangles around a vertex on the straight line from the start of around[0] to that of around[2]
/// become two.
void merge_four(Mesh& mesh, const std::vector<HalfEdge>& around) {
  const PlanarMesh& t = mesh.triangles();
  std::array<HalfEdge, 4> beyond{};
  std::array<Index, 4> corner{};
  for (std::size_t i = 0; i < 4; ++i) {
    beyond[i] = t.twin(around[i]);
    corner[i] = t.from(around[i]);
  }
  const Index left = triangle_of(around[0]), right = triangle_of(around[2]);
  mesh.replace(left, corner[0], corner[1], corner[2]);
  mesh.replace(right, corner[2], corner[3], corner[0]);
  mesh.attach(3 * left + 2, beyond[0]);
  mesh.attach(3 * left, beyond[1]);
  mesh.attach(3 * right + 2, beyond[2]);
  mesh.attach(3 * right, beyond[3]);
  mesh.join(3 * left + 1, 3 * right + 1);
  mesh.discard(triangle_of(around[1]));
  mesh.discard(triangle_of(around[3]));
}

}  // namespace

std::vector<Index> remove(Mesh& mesh, Index vertex) {
  std::vector<HalfEdge> around = links(mesh, vertex);
  std::vector<Index> places;
  places.reserve(around.size());
  for (const HalfEdge h : around) places.push_back(triangle_of(h));
  std::vector<Edge> suspects = shed(mesh, vertex, around.size());
  around = links(mesh, vertex);
  if (around.size() == 3) {
    merge_three(mesh, around);
  } else {
    const PlanarMesh& t = mesh.triangles();
    const auto straight = [&](std::size_t i) {
      return mesh.side(t.from(around[i]), t.from(around[i + 2]), vertex) == Sign::zero;
    };
    if (around.size() != 4 || (!straight(0) && !straight(1)))
      throw Abandon(Outcome::inconsistent_predicate, "a vertex cannot be taken out of its star");
    if (!straight(0)) std::rotate(around.begin(), around.begin() + 1, around.end());
    suspects.push_back({t.from(around[0]), t.from(around[2])});
    merge_four(mesh, around);
  }
  mesh.restore(std::move(suspects));
  places.erase(std::remove_if(places.begin(), places.end(), [&](Index t) { return !mesh.inside(t); }),
               places.end());
  return places;
}

}  // namespace tribunal::constrained
