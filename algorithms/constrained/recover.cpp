#include "algorithms/constrained/recover.hpp"

#include "algorithms/constrained/channel.hpp"

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

/// Makes the end of the channel a neighbour of its start, by a held edge.
void join_ends(Mesh& mesh, const Channel& channel, Index segment, Recovery recovery, Recovered& recovered) {
  std::vector<Edge> suspects;
  if (recovery == Recovery::swaps)
    suspects = swap_away(mesh, channel, recovered.swaps);
  else
    fill(mesh, channel);
  const HalfEdge h = mesh.edge(channel.start, channel.end);
  if (h == PlanarMesh::none)
    throw Abandon(Outcome::inconsistent_predicate, "a segment was not brought into the mesh");
  put_on(mesh, h, segment, recovered);
  recovered.swaps += mesh.restore(std::move(suspects));
}

}  // namespace

std::optional<Index> recover(Mesh& mesh, Index a, Index b, Index segment, Recovery recovery,
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

}  // namespace tribunal::constrained
