// The edges of a mesh that lie on input segments.
#pragma once

#include "algorithms/constrained/mesh.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace tribunal::refinement {

/// A part of an input segment that is one edge. Where segments overlap there is one for each.
struct Subsegment {
  Edge ends;
  Index segment;
};

/// All of them, segment by segment as `runs` (segment, piece) lists their pieces; `name` says which point a
/// vertex of the mesh is. O(n log n).
template <class Name>
std::vector<Subsegment> find_subsegments(const constrained::Mesh& mesh,
                                         std::span<const std::array<Index, 2>> runs, Name name) {
  const PlanarMesh& t = mesh.triangles();
  std::vector<std::pair<Index, Edge>> held;
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h)
    if (mesh.held(h) && h < t.twin(h)) held.push_back({mesh.piece(h), {name(t.from(h)), name(t.to(h))}});
  std::sort(held.begin(), held.end());
  std::vector<Subsegment> found;
  for (const auto& [segment, piece] : runs) {
    auto part = std::lower_bound(held.begin(), held.end(), std::pair{piece, Edge{0, 0}});
    for (; part != held.end() && part->first == piece; ++part) found.push_back({part->second, segment});
  }
  return found;
}

}  // namespace tribunal::refinement
