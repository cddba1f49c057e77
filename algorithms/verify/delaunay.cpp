#include "algorithms/verify/delaunay.hpp"

#include "algorithms/verify/exact_signs.hpp"

#include <algorithm>

namespace tribunal::verify {

std::uint64_t check_circles(std::span<const Point2> points, std::span<const SoundTriangle> triangles,
                            std::span<const EdgeUse> uses, FaultList& faults,
                            std::span<const std::array<std::uint32_t, 2>> held) {
  std::uint64_t ties = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2 || edge[0].flat || edge[1].flat || edge[0].upward == edge[1].upward) return;
    if (std::binary_search(held.begin(), held.end(), std::array{edge[0].low, edge[0].high})) return;
    const SoundTriangle& first = triangles[edge[0].sound];
    const SoundTriangle& second = triangles[edge[1].sound];
    const std::uint32_t apex = first.corners[edge[0].corner], other_apex = second.corners[edge[1].corner];
    const Sign sign =
        opposite_angles(points[apex], points[other_apex], points[edge[0].from()], points[edge[0].to()]);
    if (sign == Sign::zero) ++ties;
    if (sign == Sign::negative)
      faults.add(FaultKind::non_delaunay, {first.index, second.index},
                 {edge[0].low, edge[0].high, apex, other_apex}, "have an apex inside each other's circle");
  });
  return ties;
}

}  // namespace tribunal::verify
