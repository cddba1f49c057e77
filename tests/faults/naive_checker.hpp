// A second opinion on small meshes: each fault by its definition, in quadratic time, by 128-bit integers.
#pragma once

#include "algorithms/verify/verify.hpp"
#include "tests/faults/samples.hpp"

#include <compare>
#include <ostream>
#include <set>
#include <vector>

namespace tribunal::faults {

/// A fault without its wording; triangles and points sorted.
struct Finding {
  verify::FaultKind kind;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> points;
  friend auto operator<=>(const Finding&, const Finding&) = default;
  friend bool operator==(const Finding&, const Finding&) = default;
};
std::ostream& operator<<(std::ostream& out, const Finding& finding);

/// Sorts the numbers of a finding.
Finding finding(verify::FaultKind kind, std::vector<std::uint32_t> triangles,
                std::vector<std::uint32_t> points);
Finding finding(const verify::Fault& fault);

/// The kinds that the naive checker decides, all but crossing_edges in full detail.
const std::set<verify::FaultKind>& naive_kinds();

/// All faults of naive_kinds() but crossings.
std::set<Finding> naive_findings(const std::vector<LatticePoint>& points,
                                 const std::vector<Triangle>& triangles);

/// Whether two different triangles with an area overlap: two edges cross, or a vertex is inside an edge or a
/// triangle.
bool naive_overlap(const std::vector<LatticePoint>& points, const std::vector<Triangle>& triangles);

/// Whether what a crossing_edges fault says of these points is so: (vertex, edge), (edge, edge) or (vertex,
/// triangle).
bool is_overlap(const std::vector<LatticePoint>& points, const std::vector<std::uint32_t>& named);

}  // namespace tribunal::faults
