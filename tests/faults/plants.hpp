// Faults to plant into valid meshes, each with what a checker must say of it.
#pragma once

#include "tests/faults/naive_checker.hpp"
#include "tests/faults/samples.hpp"

#include <optional>
#include <ostream>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal::faults {

using Kinds = std::set<verify::FaultKind>;

struct Planted {
  std::vector<LatticePoint> points;
  std::vector<Triangle> triangles;
  std::vector<Triangle> neighbours = {};  ///< empty: not given
  std::vector<Finding> expected = {};     ///< each of these must be named
  Kinds alongside = {};                   ///< other kinds that may be named; all the rest must not be
};

/// A way to break a mesh. `plant` gives nothing where the sample has no place for it, or where exact
/// reasoning says that the mesh would still be valid.
struct Plant {
  std::string_view name;
  std::optional<Planted> (*plant)(const Sample&, Random&);
};

inline std::ostream& operator<<(std::ostream& out, const Plant& plant) { return out << plant.name; }

std::span<const Plant> triangle_plants();  ///< triangles lost, doubled, turned, flipped
std::span<const Plant> point_plants();     ///< sites lost, added, moved, swapped
std::span<const Plant> sheet_plants();     ///< triangles laid over others or into other pieces

}  // namespace tribunal::faults
