// The triangles of a mesh one by one, and their edges brought together.
#pragma once

#include "algorithms/verify/fault_list.hpp"
#include "algorithms/verify/sites.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tribunal::verify {

/// A triangle fit for the checks that follow: corners in range, distinct, by their first copies, in the order
/// listed.
struct SoundTriangle {
  std::uint32_t index;  ///< in the mesh
  std::array<std::uint32_t, 3> corners;
  Sign orientation;
};

/// Judges each triangle by itself and against its doubles; keeps the sound ones, in the order of the mesh.
std::vector<SoundTriangle> check_triangles(std::span<const Point2> points, const Sites& sites,
                                           const Mesh& mesh, FaultList& faults);

/// One triangle's use of an edge.
struct EdgeUse {
  std::uint32_t low, high;  ///< the ends
  std::uint32_t sound;      ///< which sound triangle
  std::uint8_t corner;      ///< its corner across from the edge
  bool upward;  ///< it has low -> high on its counter-clockwise way round, hence lies on the left of it
  bool flat;    ///< it has no area, hence no side; `upward` is as listed

  std::uint32_t from() const { return upward ? low : high; }
  std::uint32_t to() const { return upward ? high : low; }
};

/// All uses of edges, those of one edge next to each other, by triangle. O(t log t).
std::vector<EdgeUse> edge_uses(std::span<const SoundTriangle> triangles);

/// Calls visit(span of the uses of one edge) for each edge, in order.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace tribunal::verify
