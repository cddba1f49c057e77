// How the triangles hang together: edges, vertices, pieces, neighbours. No coordinates.
#pragma once

#include "algorithms/verify/triangles.hpp"

namespace tribunal::verify {

/// Every edge has one triangle, or two on opposite sides of it.
void check_edges(std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses, FaultList& faults);

/// The triangles around each vertex form one fan, open or closed.
void check_vertices(std::size_t points, std::span<const SoundTriangle> triangles,
                    std::span<const EdgeUse> uses, FaultList& faults);

/// Every site is in a triangle.
void check_sites(const Sites& sites, std::span<const SoundTriangle> triangles, FaultList& faults);

/// The triangles form one piece, connected across edges.
void check_pieces(std::span<const SoundTriangle> triangles, std::span<const EdgeUse> uses, FaultList& faults);

/// mesh.neighbours, if given, names across each edge the triangle that is there. Edges that have more than
/// two triangles are left out: they have no neighbour to name.
void check_neighbours(const Mesh& mesh, std::span<const SoundTriangle> triangles,
                      std::span<const EdgeUse> uses, FaultList& faults);

}  // namespace tribunal::verify
