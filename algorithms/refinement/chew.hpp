// Circumcentre refinement: Steiner points at circumcentres until all triangles are small and round enough.
#pragma once

#include "algorithms/constrained/constrained.hpp"
#include "algorithms/refinement/measure.hpp"
#include "algorithms/refinement/shape.hpp"
#include "algorithms/refinement/size_field.hpp"
#include "algorithms/refinement/steiner_mesh.hpp"

#include <cstdint>
#include <span>

namespace tribunal::refinement {

struct ChewOptions {
  AngleBound bound = AngleBound::degrees(30);
  Size size = {};
  std::uint64_t most_vertices = 2'000'000;
  TriangleMeasure* measure = nullptr;  ///< what triangles may fail, too; null: nothing
};

struct ChewCounts {
  std::uint64_t circumcentres = 0;       ///< inserted
  std::uint64_t deleted = 0;             ///< of them, for the sake of a split nearby
  std::uint64_t splits = 0;              ///< of subsegments
  std::uint64_t refused_splits = 0;      ///< where rounding would have inverted a cell
  std::uint64_t steps = 0;               ///< of looks towards circumcentres
  std::uint64_t tests = 0;               ///< triangles measured
  std::uint64_t stale = 0;               ///< entries of the heap whose triangle was gone
  std::uint64_t small_input_angles = 0;  ///< below the bound
  std::uint64_t forced = 0;      ///< triangles left below the bound for the sake of small input angles
  std::uint64_t unresolved = 0;  ///< triangles left because doubles end there
};

struct Refinement {
  /// Outcome, reason and what was in the way where the graph was refused.
  ConstrainedTriangulation report;
  Refined mesh;
  ChewCounts counts;
};

/// Refines a mesh. Throws Abandon. See below.
ChewCounts refine_mesh(SteinerMesh& mesh, const ChewOptions& options);

/// Refines the graph's domain as Barth's section 3.5 describes it (Chew 1989, 1993): of the triangles that
/// fail, the one of the largest circumcircle comes first; its circumcentre, rounded, is inserted if it is
/// seen from the triangle; if a held edge is in the way, that is split in halves, and circumcentres closer
/// than half its length to its middle are deleted. A triangle fails when its smallest angle is below the
/// bound (decided exactly) or its longest edge is above the size.
///
/// With input angles of 60 degrees and more and a bound of at most 30 degrees it ends, all angles between the
/// bound and 180 degrees minus twice the bound. Smaller input angles force smaller angles near them, which
/// are counted and left. Beyond `most_vertices` it gives up: outcome refused_input. Sites are first inserted
/// in `order`. O(n log n) for n vertices of a heap, and walks of constant length where triangles fail by
/// little.
Refinement refine_by_circumcentres(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                                   const ChewOptions& options);

}  // namespace tribunal::refinement
