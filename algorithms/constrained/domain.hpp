// Which triangles of a mesh with held edges belong to the domain.
#pragma once

#include "algorithms/constrained/recover.hpp"

#include <string>
#include <vector>

namespace tribunal::constrained {

/// A hole of the graph that marks nothing, or that the backend cannot be asked about.
struct NoHole : Abandon {
  NoHole(Index which, const std::string& reason, Outcome why = Outcome::refused_input)
      : Abandon(why, reason), hole(which) {}
  Index hole;
};

/// Segments that enclose nothing, ending at these vertices of the mesh.
struct OpenLoop : Abandon {
  explicit OpenLoop(std::vector<Index> at)
      : Abandon(Outcome::refused_input, "an open loop"), ends(std::move(at)) {}
  std::vector<Index> ends;
};

/// For each triangle whether it belongs to the domain; ghosts never do. Throws NoHole for a hole point
/// outside the domain or on a segment, OpenLoop where the even-odd rule has no meaning, or nothing is
/// enclosed and segments have loose ends, Abandon where the domain is empty otherwise. Linear, and for each
/// hole a walk.
std::vector<bool> find_domain(const Mesh& mesh, const Recovered& recovered, const Graph& graph);

}  // namespace tribunal::constrained
