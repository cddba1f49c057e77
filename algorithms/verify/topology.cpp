#include "algorithms/verify/topology.hpp"

#include "algorithms/verify/disjoint_sets.hpp"

#include <algorithm>

namespace tribunal::verify {

void check_edges(std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses, FaultList& faults) {
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const bool crowded = edge.size() > 2;
    const bool folded =
        edge.size() == 2 && edge[0].upward == edge[1].upward && !edge[0].flat && !edge[1].flat;
    if (!crowded && !folded) return;
    std::vector<std::uint32_t> around;
    for (const EdgeUse& use : edge) around.push_back(triangles[use.sound].index);
    if (crowded)
      faults.add(FaultKind::non_manifold_edge, around, {edge[0].low, edge[0].high},
                 "more than two share an edge");
    else
      faults.add(FaultKind::folded_edge, around, {edge[0].low, edge[0].high},
                 "lie on the same side of their edge");
  });
}

void check_vertices(std::size_t points, std::span<const SoundTriangle> triangles,
                    std::span<const EdgeUse> uses, FaultList& faults) {
  // Corner c of sound triangle t is 3 t + c. Across an edge, the corners at each of its ends join; what joins
  // is a fan.
  DisjointSets fans(3 * triangles.size());
  const auto corner_at = [&](const EdgeUse& use, std::uint32_t vertex) {
    const auto& corners = triangles[use.sound].corners;
    return 3 * use.sound +
           static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  };
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& other : edge.subspan(1))
      for (const std::uint32_t end : {edge[0].low, edge[0].high})
        fans.unite(corner_at(edge[0], end), corner_at(other, end));
  });

  std::vector<std::uint32_t> fan_count(points);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t c = 0; c < 3; ++c)
      if (fans.find(3 * t + c) == 3 * t + c) ++fan_count[triangles[t].corners[c]];
  if (std::none_of(fan_count.begin(), fan_count.end(), [](std::uint32_t count) { return count > 1; })) return;

  std::vector<std::pair<std::uint32_t, std::uint32_t>> surplus;  // (vertex, first triangle of a fan)
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t c = 0; c < 3; ++c)
      if (fan_count[triangles[t].corners[c]] > 1 && fans.find(3 * t + c) == 3 * t + c)
        surplus.emplace_back(triangles[t].corners[c], triangles[t].index);
  std::sort(surplus.begin(), surplus.end());
  for (std::size_t begin = 0, end = 0; begin < surplus.size(); begin = end) {
    std::vector<std::uint32_t> firsts;
    for (; end < surplus.size() && surplus[end].first == surplus[begin].first; ++end)
      firsts.push_back(surplus[end].second);
    faults.add(FaultKind::non_manifold_vertex, firsts, {surplus[begin].first},
               "form separate fans around a vertex");
  }
}

void check_sites(const Sites& sites, std::span<const SoundTriangle> triangles, FaultList& faults) {
  std::vector<bool> used(sites.representative.size());
  for (const SoundTriangle& triangle : triangles)
    for (const std::uint32_t corner : triangle.corners) used[corner] = true;
  for (std::uint32_t point = 0; point < used.size(); ++point)
    if (!used[point] && sites.representative[point] == point)
      faults.add(FaultKind::missing_site, {}, {point}, "is in no triangle");
}

void check_pieces(std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses,
                  FaultList& faults) {
  DisjointSets pieces(triangles.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& other : edge.subspan(1)) pieces.unite(edge[0].sound, other.sound);
  });
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (pieces.find(t) == t) firsts.push_back(triangles[t].index);
  if (firsts.size() > 1) faults.add(FaultKind::not_connected, firsts, {}, "belong to separate pieces");
}

void check_neighbours(const Mesh& mesh, std::span<const SoundTriangle> triangles,
                      std::span<const EdgeUse> uses, FaultList& faults) {
  if (mesh.neighbours.empty()) return;
  if (mesh.neighbours.size() != mesh.triangles.size()) {
    faults.add(FaultKind::wrong_neighbour, {}, {}, "there are not as many rows of neighbours as triangles");
    return;
  }
  const auto compare = [&](const EdgeUse& use, std::uint32_t across) {
    const std::uint32_t triangle = triangles[use.sound].index;
    const std::uint32_t given = mesh.neighbours[triangle][use.corner];
    if (given == across) return;
    std::vector<std::uint32_t> named{triangle};
    if (given < mesh.triangles.size()) named.push_back(given);
    faults.add(FaultKind::wrong_neighbour, named, {use.low, use.high},
               across == no_neighbour ? "has nothing across the edge, but a neighbour is given"
                                      : "has another triangle across the edge than the neighbour given");
  };
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) compare(edge[0], no_neighbour);
    if (edge.size() != 2) return;
    compare(edge[0], triangles[edge[1].sound].index);
    compare(edge[1], triangles[edge[0].sound].index);
  });
}

}  // namespace tribunal::verify
