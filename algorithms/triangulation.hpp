// The value that a planar triangulation algorithm returns.
#pragma once

#include "algorithms/outcome.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tribunal {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;
using Edge = std::array<Index, 2>;

/// The edge between a and b, its smaller index first.
constexpr Edge undirected(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// Structural counters: plain integers, always on, independent of the backend as long as its signs are right.
/// tau, tau_with_ghosts and flips depend on points and order alone (identities: Guibas, Knuth, Sharir 1992).
struct Counters {
  std::uint64_t tau = 0;  ///< finite triangles incident to each new site right after its insertion, summed
  std::uint64_t tau_with_ghosts = 0;  ///< the same with the unbounded (ghost) triangles
  std::uint64_t created = 0;          ///< triangles ever made, ghosts and short-lived ones included
  std::uint64_t flips = 0;            ///< edge flips; 0 where the algorithm retriangulates cavities
  std::uint64_t on_edge = 0;          ///< sites that landed on an edge, hull edges included
  std::uint64_t outside_hull = 0;     ///< sites on the hull when inserted, counted from the third site on
  std::uint64_t conflict_tests =
      0;  ///< circle tests, ghosts included; pairs of segments tried for a crossing
  std::uint64_t location_steps = 0;  ///< walk steps, nodes of search structures visited or circles scanned
};

/// The counters by the names that statistics and rows give them.
inline std::array<std::pair<const char*, std::uint64_t>, 8> by_name(const Counters& c) {
  return {{{"tau", c.tau},
           {"tau_with_ghosts", c.tau_with_ghosts},
           {"created", c.created},
           {"flips", c.flips},
           {"on_edge", c.on_edge},
           {"outside_hull", c.outside_hull},
           {"conflict_tests", c.conflict_tests},
           {"location_steps", c.location_steps}}};
}

/// Shape of the history DAG (Green-Sibson). Depth of a site: nodes on its path from the root to the triangle
/// that held it when it was inserted, the root not counted.
struct History {
  std::uint64_t nodes = 0;
  double depth_mean = 0;       ///< over all insertions
  double depth_late_mean = 0;  ///< over the last tenth of them
  std::uint64_t depth_max = 0;
};

/// What came of one run. Indices are into the points as given; a duplicate is stood for by its first
/// occurrence. A point set of dimension 0 or 1 has no triangles; its path is in `edges`, in order along the
/// line.
struct Triangulation {
  Outcome outcome = Outcome::ok;
  std::string reason;  ///< one line where the outcome is not ok
  int dimension = 0;   ///< 0, 1 or 2
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;                          ///< dimension 1 only
  std::vector<std::pair<Index, Index>> duplicates;  ///< (repeated index, first occurrence)
  std::uint64_t hull = 0;                           ///< sites on the hull boundary, collinear ones included
  Counters counters;
  std::optional<History> history;
};

}  // namespace tribunal
