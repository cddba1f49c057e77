#include "algorithms/constrained/recover.hpp"

#include "algorithms/constrained/channel.hpp"

#include <algorithm>

namespace tribunal::constrained {
namespace {

/// Swaps crossed edges away, in turn, those that stand in a nonconvex quadrilateral again later, until none
/// crosses the segment (Sloan 1993; Barth section 3.5, "local transformations"). Returns the edges made,
/// whose circles are to be restored.
std::vector<Edge> swap_away(Mesh& mesh, const Channel& channel, std::uint64_t& swaps) {
  const PlanarMesh& t = mesh.triangles();
  const Index a = channel.start, b = channel.end;
  std::vector<Edge> crossing = channel.crossed, settled;
  const std::uint64_t crossings = crossing.size();
  Budget budget(4 * (crossings + 2) * (crossings + 2), "recovering a segment by swaps");
  for (std::size_t turn = 0; turn < crossing.size(); ++turn) {
    budget.spend();
    const Edge old = crossing[turn];
    const HalfEdge h = mesh.edge(old[0], old[1]);
    if (!mesh.swappable(h)) {
      crossing.push_back(old);
      continue;
    }
    const Index s = t.corner(h), p = t.corner(t.twin(h));
    mesh.swap(h);
    ++swaps;
    const bool at_end = s == a || s == b || p == a || p == b;
    const bool crosses = !at_end && mesh.side(a, b, s) != mesh.side(a, b, p);
    (crosses ? crossing : settled).push_back({s, p});
  }
  return settled;
}

/// Notes that a segment lies on the edge h.
void put_on(Mesh& mesh, HalfEdge h, Index segment, Recovered& recovered) {
  if (mesh.held(h)) {
    ++recovered.pieces[mesh.piece(h)].segments;
  } else {
    mesh.hold(h, static_cast<Index>(recovered.pieces.size()));
    recovered.pieces.push_back({segment});
  }
  recovered.runs.push_back({segment, mesh.piece(h)});
}

/// Each triangle that fills a channel looks at all that is left of its side, and where a segment runs beside
/// a row of points these looks add up to a square; swaps seldom do.
constexpr std::size_t longest_filled = 256;

/// Makes the end of the channel a neighbour of its start, by a held edge.
void join_ends(Mesh& mesh, const Channel& channel, Index segment, Recovery recovery, Recovered& recovered) {
  std::vector<Edge> suspects;
  if (recovery == Recovery::swaps || channel.crossed.size() > longest_filled)
    suspects = swap_away(mesh, channel, recovered.swaps);
  else
    fill(mesh, channel);
  const HalfEdge h = mesh.edge(channel.start, channel.end);
  if (h == PlanarMesh::none)
    throw Abandon(Outcome::inconsistent_predicate, "a segment was not brought into the mesh");
  put_on(mesh, h, segment, recovered);
  recovered.swaps += mesh.restore(std::move(suspects));
}

/// Whether b has fewer neighbours than a, who has many. O(1).
bool has_smaller_star(const Mesh& mesh, Index b, Index a) {
  constexpr int many = 64;
  const HalfEdge first_a = mesh.link(a), first_b = mesh.link(b);
  HalfEdge at_a = first_a, at_b = first_b;
  for (int i = 0; i < many; ++i) {
    at_a = mesh.next_link(at_a);
    at_b = mesh.next_link(at_b);
    if (at_a == first_a) return false;
    if (at_b == first_b) {
      for (++i; i < many && at_a != first_a; ++i) at_a = mesh.next_link(at_a);
      return at_a != first_a;
    }
  }
  return false;
}

std::optional<Index> recover_forwards(Mesh& mesh, Index a, Index b, Index segment, Recovery recovery,
                                      Recovered& recovered) {
  while (a != b) {
    const Channel channel = trace(mesh, a, b);
    if (channel.blocked_by != free_edge) return recovered.pieces[channel.blocked_by].segment;
    if (channel.edge != PlanarMesh::none)
      put_on(mesh, channel.edge, segment, recovered);
    else
      join_ends(mesh, channel, segment, recovery, recovered);
    a = channel.end;
    if (a != b) recovered.touches.push_back({segment, a});
  }
  return std::nullopt;
}

}  // namespace

// Where a segment leaves a vertex is found by going around it: around the end with few neighbours.
std::optional<Index> recover(Mesh& mesh, Index a, Index b, Index segment, Recovery recovery,
                             Recovered& recovered) {
  if (a == b) return std::nullopt;
  if (const HalfEdge h = mesh.edge(a, b); h != PlanarMesh::none) {  // as most segments are from the start
    put_on(mesh, h, segment, recovered);
    return std::nullopt;
  }
  if (!has_smaller_star(mesh, b, a)) return recover_forwards(mesh, a, b, segment, recovery, recovered);
  const auto runs = static_cast<std::ptrdiff_t>(recovered.runs.size()),
             touches = static_cast<std::ptrdiff_t>(recovered.touches.size());
  const auto crossed = recover_forwards(mesh, b, a, segment, recovery, recovered);
  std::reverse(recovered.runs.begin() + runs, recovered.runs.end());
  std::reverse(recovered.touches.begin() + touches, recovered.touches.end());
  return crossed;
}

}  // namespace tribunal::constrained
