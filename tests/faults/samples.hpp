// Valid meshes to begin with: small Delaunay triangulations made by definition, many kinds of point sets.
#pragma once

#include "datasets/random.hpp"
#include "tests/faults/lattice.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tribunal::faults {

using Triangle = std::array<std::uint32_t, 3>;

struct Sample {
  std::string_view family;
  std::vector<LatticePoint> points;
  std::vector<Triangle> triangles;
};

/// A Delaunay triangulation of the points numbered by `sites` (distinct, not all collinear), from its
/// definition: the triples whose circle is empty; where more than three points share an empty circle, ears
/// are cut off their polygon at random. Triangles are counter-clockwise and in no particular order. O(n^4).
std::vector<Triangle> triangulate_by_definition(const std::vector<LatticePoint>& points,
                                                const std::vector<std::uint32_t>& sites, Random& random);

/// The first index of each position.
std::vector<std::uint32_t> distinct_sites(const std::vector<LatticePoint>& points);

/// The triangles across from the corners, verify::no_neighbour on the boundary.
std::vector<Triangle> neighbours_of(const std::vector<Triangle>& triangles);

/// Sample number i; its family is i modulo `families`.
inline constexpr std::uint32_t families = 7;
Sample make_sample(std::uint32_t i);

/// Samples 0 .. count-1.
std::vector<Sample> make_samples(std::uint32_t count);

}  // namespace tribunal::faults
